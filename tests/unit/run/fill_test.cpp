// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace frostfill
{
namespace
{

using test::readFile;
using test::TemporaryFolder;

/// Two sets of four spheres in a cube: over in a moment.
FillRequest smallRequest(const std::filesystem::path& directory)
{
    FillRequest request;
    request.scene = presetScene(Preset::paper, "cube");
    request.scene.spheres = {0.3, 8, false, 2, 2};
    request.scene.frames.enabled = false;
    request.directory = directory;
    return request;
}

std::size_t rowsOf(const std::filesystem::path& file)
{
    const std::string text = readFile(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) - 1;
}

std::size_t entriesIn(const std::filesystem::path& directory)
{
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory))
    {
        ++count;
    }
    return count;
}

TEST(FillRun, DividesItsTimeIntoPartsWithoutAGap)
{
    const TemporaryFolder folder;
    // What a caller does during a run is long here, so that each part can be told by its length.
    using std::chrono::milliseconds;
    FillObserver slow;
    bool first = true;
    slow.loaded = [] { std::this_thread::sleep_for(milliseconds(200)); };
    slow.planned = [](const FillPlan&) { std::this_thread::sleep_for(milliseconds(300)); };
    slow.progressed = [&](const FillProgress&)
    {
        std::this_thread::sleep_for(milliseconds(first ? 400 : 0));
        first = false;
    };
    const auto start = std::chrono::steady_clock::now();
    const FillResult result = fill(smallRequest(folder / "run"), slow);
    const double outside =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto time = nlohmann::json::parse(result.summary)["time"];
    double sum = 0;
    for (const char* phase :
         {"loading", "preparing", "estimating", "simulating", "drawing_the_rest", "judging"})
    {
        ASSERT_TRUE(time["phases"].contains(phase)) << phase;
        sum += time["phases"][phase].get<double>();
    }
    EXPECT_EQ(time["phases"].size(), 6u);
    EXPECT_GE(time["phases"]["preparing"].get<double>(), 0.2);
    EXPECT_GE(time["phases"]["estimating"].get<double>(), 0.3);
    EXPECT_GE(time["phases"]["simulating"].get<double>(), 0.4);
    EXPECT_NEAR(time["wall"].get<double>(), sum, 1e-5 * sum);
    EXPECT_LE(sum, outside);
    EXPECT_GE(sum, outside - 0.15); // what comes before the first part and after the last
}

TEST(FillRun, WritesEveryFileOfARun)
{
    const TemporaryFolder folder;
    const FillResult result = fill(smallRequest(folder / "run"));
    EXPECT_FALSE(result.failure) << *result.failure;
    EXPECT_EQ(result.spheres, 8u);
    EXPECT_EQ(rowsOf(folder / "run/spheres.csv"), 8u);
    EXPECT_EQ(rowsOf(folder / "run/polygons.csv"), 768u);
    EXPECT_EQ(rowsOf(folder / "run/sets.csv"), result.sets.size());
    EXPECT_TRUE(std::filesystem::exists(folder / "run/mesh.ply"));
    EXPECT_EQ(readFile(folder / "run/summary.json"), result.summary);
    EXPECT_EQ(entriesIn(folder / "run"), 5u);
}

TEST(FillRun, SummarisesWhatRepeatsTheRun)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(folder / "a");
    const FillResult first = fill(request);
    const auto summary = nlohmann::ordered_json::parse(first.summary);
    for (const char* key : {"scene", "machine", "spheres", "polygons", "error", "time",
                            "operations", "state_hash", "frames"})
    {
        EXPECT_TRUE(summary.contains(key)) << key;
    }
    EXPECT_EQ(summary["spheres"]["total"], 8);
    EXPECT_EQ(summary["polygons"]["total"], 768);

    request.scene = sceneFromJson(summary["scene"], "summary.json");
    request.directory = folder / "b";
    EXPECT_EQ(fill(request).stateHash, first.stateHash);
    for (const char* file : {"spheres.csv", "polygons.csv", "mesh.ply"})
    {
        EXPECT_EQ(readFile(folder / "a" / file), readFile(folder / "b" / file)) << file;
    }
}

TEST(FillRun, WritesEverythingWhenItIsStopped)
{
    const TemporaryFolder folder;
    int asked = 0;
    FillObserver observer;
    observer.stopRequested = [&] { return ++asked >= 5; };
    const FillResult result = fill(smallRequest(folder / "run"), observer);
    EXPECT_TRUE(result.stopped);
    EXPECT_LT(asked, 10); // the whole run asks some 580 times
    EXPECT_EQ(entriesIn(folder / "run"), 5u);
    EXPECT_EQ(nlohmann::json::parse(result.summary)["outcome"], "stopped");
}

TEST(FillRun, LeavesAnEarlierRunAlone)
{
    const TemporaryFolder folder;
    (void)fill(smallRequest(folder / "run"));
    const std::string before = readFile(folder / "run/summary.json");
    test::expectError(
        ErrorCode::cannotCreate, [&] { (void)fill(smallRequest(folder / "run")); }, "--overwrite");
    EXPECT_EQ(readFile(folder / "run/summary.json"), before);
}

TEST(FillRun, SimulatesTheSameWithAndWithoutFrames)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(folder / "a");
    const FillResult without = fill(request);
    request.directory = folder / "b";
    request.scene.frames.enabled = true;
    request.scene.frames.limit = 6;
    request.scene.size = {96, 64};
    request.scene.samples = 1;
    const FillResult with = fill(request);
    EXPECT_EQ(with.stateHash, without.stateHash);
    EXPECT_FALSE(with.failure) << *with.failure;
    EXPECT_GE(with.frames, 3u);
    EXPECT_LE(with.frames, 6u);
    EXPECT_EQ(entriesIn(folder / "b/frames"), with.frames);
    EXPECT_TRUE(std::filesystem::exists(folder / "b/frames/frame_00000.png"));
    EXPECT_EQ(nlohmann::json::parse(with.summary)["frames"], with.frames);
}

// Long steps with nothing lost in a bounce lead the paper's spheres through the wall.
TEST(FillRun, FailsWhenACentreEndsOutsideButKeepsTheFiles)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(folder / "run");
    request.scene = presetScene(Preset::paper, "torus");
    request.scene.spheres.radius = 0.1;
    request.scene.spheres.count = 40;
    request.scene.motion.dt = 0.1;
    request.scene.motion.restitution = 1;
    request.scene.frames.enabled = false;
    const FillResult result = fill(request);
    EXPECT_GT(result.quality.centresOutside, 0u);
    ASSERT_TRUE(result.failure);
    EXPECT_NE(result.failure->find("outside"), std::string::npos) << *result.failure;
    const auto summary = nlohmann::json::parse(result.summary);
    EXPECT_EQ(summary["outcome"], "failed");
    EXPECT_EQ(summary["error"]["centres_outside"], result.quality.centresOutside);
    EXPECT_EQ(entriesIn(folder / "run"), 5u);
}

// There is always room for another, as they leave.
TEST(FillRun, UntilFullEndsWhenTheSpheresTakeMoreThanTheObject)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(folder / "run");
    request.scene = presetScene(Preset::paper, "torus");
    request.scene.spheres.radius = 0.2;
    request.scene.spheres.count.reset();
    request.scene.motion.dt = 0.1;
    request.scene.motion.restitution = 1;
    request.scene.frames.enabled = false;
    const FillResult result = fill(request);
    EXPECT_TRUE(result.overfull);
    ASSERT_TRUE(result.failure);
    EXPECT_NE(result.failure->find("more than the object's volume"), std::string::npos)
        << *result.failure;
    EXPECT_EQ(entriesIn(folder / "run"), 5u);
}

TEST(FillRun, RefusesBlankPicturesButKeepsTheFiles)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(folder / "run");
    request.scene.frames.enabled = true;
    request.scene.frames.limit = 2;
    request.scene.size = {96, 64};
    request.scene.camera.target = Eigen::Vector3d(1e6, 0, 0);
    const FillResult result = fill(request);
    ASSERT_TRUE(result.failure);
    EXPECT_NE(result.failure->find("blank"), std::string::npos);
    EXPECT_EQ(entriesIn(folder / "run"), 7u);
}

} // namespace
} // namespace frostfill
