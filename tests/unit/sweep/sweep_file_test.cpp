// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/sweep_file.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace frostfill
{
namespace
{

using test::expectError;

constexpr const char* kTwelveRuns = R"(
[scene]
preset = "fast"
[scene.frames]
which = "none"
[sweep]
seed = [1, 2, 3]
"spheres.radius" = [0.25, "0.2..0.3"]
object.mesh = ["cube", "sphere"]
)";

std::vector<std::string> namesOf(const std::vector<SweepRun>& runs)
{
    std::vector<std::string> names(runs.size());
    std::transform(runs.begin(), runs.end(), names.begin(),
                   [](const SweepRun& run) { return run.name; });
    return names;
}

TEST(SweepFile, HasARunForEachCombinationInTheOrderOfTheOptions)
{
    const std::vector<SweepRun> runs = parseSweep(kTwelveRuns, "sweep.toml");
    ASSERT_EQ(runs.size(), 12U);
    EXPECT_EQ(runs[0].name, "mesh=cube,radius=0.25,seed=1");
    EXPECT_EQ(runs[1].name, "mesh=cube,radius=0.25,seed=2");
    EXPECT_EQ(runs[3].name, "mesh=cube,radius=0.2..0.3,seed=1");
    EXPECT_EQ(runs[11].name, "mesh=sphere,radius=0.2..0.3,seed=3");
    EXPECT_EQ(runs[11].scene.object.mesh, "sphere");
    EXPECT_EQ(runs[11].scene.seed, 3U);
    EXPECT_FALSE(runs[11].scene.frames.enabled);
    // A radius alone fills until full, as in a scene file.
    EXPECT_FALSE(runs[0].scene.spheres.count);
    const std::vector<std::string> names = namesOf(runs);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(SweepFile, GivesEachRunTheSceneOfASceneFileWithItsValues)
{
    const std::vector<SweepRun> runs = parseSweep(kTwelveRuns, "sweep.toml");
    const Scene alone =
        parseScene("preset = \"fast\"\nseed = 2\n[frames]\nwhich = \"none\"\n"
                   "[spheres]\nradius = \"0.2..0.3\"\n[object]\nmesh = \"sphere\"\n",
                   "scene.toml");
    EXPECT_EQ(sceneToToml(runs[10].scene), sceneToToml(alone));
}

TEST(SweepFile, KeepsTheNamesOfRunsWhenOthersAreAddedOrLinesChangePlaces)
{
    const std::vector<std::string> before = namesOf(parseSweep(kTwelveRuns, "sweep.toml"));
    const std::vector<std::string> after =
        namesOf(parseSweep("[sweep]\nobject.mesh = [\"torus\", \"sphere\", \"cube\"]\n"
                           "spheres.radius = [\"0.2..0.3\", 0.1, 0.25]\nseed = [3, 2, 1, 9]\n",
                           "sweep.toml"));
    EXPECT_EQ(after.size(), 36U);
    for (const std::string& name : before)
    {
        EXPECT_NE(std::find(after.begin(), after.end(), name), after.end()) << name;
    }
}

TEST(SweepFile, SweepsVectorsWordsAndKeysOfOneLastPart)
{
    const auto runs = parseSweep("[sweep]\ncamera.target = [[0, 0, 0], [1, 0, 0.5]]\n"
                                 "discard.rule = [\"none\", \"exact\"]\n",
                                 "sweep.toml");
    ASSERT_EQ(runs.size(), 4U);
    // "rule" alone could be that of freezing.
    EXPECT_EQ(runs[3].name, "discard.rule=exact,target=1-0-0.5");
    EXPECT_EQ(*runs[3].scene.camera.target, Eigen::Vector3d(1, 0, 0.5));
}

TEST(SweepFile, FindsMeshesBesideItselfFromWhereverItIsRead)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder / "sweep.toml",
                    "[sweep]\nobject.mesh = [\"../parts/a.stl\", \"torus\"]\n");
    const auto runs = loadSweep(folder / "sweep.toml");
    EXPECT_EQ(runs[0].name, "mesh=parts-a.stl");
    EXPECT_TRUE(std::filesystem::path(runs[0].scene.object.mesh).is_absolute());
    EXPECT_EQ(std::filesystem::path(runs[0].scene.object.mesh).lexically_normal(),
              (folder.path().parent_path() / "parts/a.stl").lexically_normal());
    EXPECT_EQ(runs[1].scene.object.mesh, "torus");
}

TEST(SweepFile, GivesLongValuesAShorterNameOfTheirOwn)
{
    const std::string far(300, 'x');
    const auto runs = parseSweep(
        "[sweep]\nobject.mesh = [\"" + far + "a.stl\", \"" + far + "b.stl\"]\n", "sweep.toml");
    EXPECT_LE(runs[0].name.size(), 200U);
    EXPECT_NE(runs[0].name, runs[1].name);
}

TEST(SweepFile, SaysInWhichLineSomethingIsWrong)
{
    const auto refused = [](const char* toml, const char* line, const char* what)
    {
        expectError(
            ErrorCode::badData, [&] { (void)parseSweep(toml, "s.toml"); }, line, what);
    };
    refused("seed = [1, 2]\n", "line 1", "neither table");
    refused("[scene]\nseed = 1\n[sweep]\nseed = [1, 2]\n", "line 4", "omit one");
    refused("[sweep]\nseed = 3\n", "line 2", "must be a list");
    refused("[sweep]\nseed = []\n", "line 2", "'seed' must be");
    refused("[sweep]\nseed = [1, 2, 1]\n", "line 2", "a value twice");
    refused("[sweep]\nseed = [1, \"many\"]\n", "line 2", "'seed' must be");
    refused("[sweep]\nspheres.radios = [1]\n", "line 2", "did you mean 'spheres.radius'?");
    refused("[scene]\nspheres.count = -1\n[sweep]\nseed = [1]\n", "line 2", "spheres.count");
    refused("[sweep]\nseed = [\n", "line", "");
    expectError(
        ErrorCode::badData, [] { (void)parseSweep("[scene]\nseed = 1\n", "s.toml"); },
        "sweeps nothing");
    expectError(
        ErrorCode::inputMissing, [] { (void)loadSweep("nowhere.toml"); }, "nowhere.toml");
}

} // namespace
} // namespace frostfill
