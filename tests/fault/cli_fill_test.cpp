// SPDX-License-Identifier: MIT
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;

// A run of a moment: two sets of four spheres.
const std::string kEightInTwos =
    "fill cube --radius 0.3 --count 8 --set spheres.group_size=2 --set spheres.groups_per_set=2 ";

class FillCommand : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(FillCommand, WritesEveryFileIntoItsDirectoryByDefault)
{
    const Answer answer = run(kEightInTwos + "--size 64x48 --set frames.limit=4");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    for (const char* file : {"spheres.csv", "polygons.csv", "sets.csv", "summary.json", "mesh.ply",
                             "frames/frame_00000.png"})
    {
        EXPECT_TRUE(std::filesystem::exists(folder_ / "output/cube" / file)) << file;
    }
    EXPECT_NE(answer.output.find("frames/s"), std::string::npos) << answer.output;
    EXPECT_NE(answer.errors.find("expecting about"), std::string::npos) << answer.errors;

    EXPECT_EQ(run(kEightInTwos + "--frames none").code, 73);
    EXPECT_EQ(run(kEightInTwos + "--frames none --overwrite").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "output/cube/frames"));
}

TEST_F(FillCommand, TakesOptionsInAnyOrder)
{
    const Answer answer = run("fill --quiet --count 4 --frames none --out a cube --radius 0.3");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_EQ(answer.output + answer.errors, "");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a/summary.json"));
}

TEST_F(FillCommand, SaysWhichGivenOptionsThePresetDoesNotUse)
{
    const std::string none = kEightInTwos + "--frames none --overwrite ";
    const auto linesOfWarning = [](const Answer& answer)
    {
        EXPECT_EQ(answer.code, 0) << answer.errors;
        std::string lines;
        for (std::size_t at = answer.errors.find("warning: "); at != std::string::npos;
             at = answer.errors.find("warning: ", at + 1))
        {
            lines += answer.errors.substr(at, answer.errors.find('\n', at) - at) + "\n";
        }
        return lines;
    };
    EXPECT_EQ(
        linesOfWarning(run(
            none + "--set motion.integrator=explicit --set freezing.every_sets=3 --set threads=1")),
        "warning: the preset fast does not use motion.integrator, freezing.every_sets; the preset "
        "paper does\n");
    EXPECT_EQ(
        linesOfWarning(
            run(none + "--preset paper --set freezing.rule=one-by-one --set motion.sweeps=4")),
        "warning: the preset paper does not use motion.sweeps, freezing.rule; the preset fast "
        "does\n");
    EXPECT_EQ(
        linesOfWarning(run(none + "--preset paper --set motion.integrator=explicit --motion fall")),
        "");
    EXPECT_EQ(linesOfWarning(run(none + "--quiet --set search.spheres=grid")), "");
    // The summary of a run has the settings of both presets.
    EXPECT_EQ(linesOfWarning(run("fill output/cube/summary.json --out b")), "");
}

TEST_F(FillCommand, PrintsOneJsonDocumentOnStandardOutput)
{
    const Answer answer = run(kEightInTwos + "--frames none --json");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto summary = nlohmann::json::parse(answer.output, nullptr, false);
    ASSERT_TRUE(summary.is_object()) << answer.output;
    EXPECT_EQ(summary["spheres"]["total"], 8);
    EXPECT_EQ(summary["error"]["centres_outside"], 0);
    EXPECT_EQ(summary["frames"], 0);
    EXPECT_EQ(answer.output, readFile(folder_ / "output/cube/summary.json"));
}

TEST_F(FillCommand, RepeatsARunFromItsSummaryOrASceneFile)
{
    ASSERT_EQ(run(kEightInTwos + "--seed 7 --frames none --quiet --out a").code, 0);
    ASSERT_EQ(run("fill a/summary.json --quiet --out b").code, 0);
    EXPECT_EQ(readFile(folder_ / "a/spheres.csv"), readFile(folder_ / "b/spheres.csv"));

    writeFile(folder_ / "c.toml", "seed = 7\n[object]\nmesh = \"cube\"\n[spheres]\nradius = 0.3\n"
                                  "count = 8\ngroup_size = 2\ngroups_per_set = 2\n"
                                  "[frames]\nwhich = \"none\"\n");
    ASSERT_EQ(run("fill c.toml --quiet --out c").code, 0);
    EXPECT_EQ(readFile(folder_ / "a/spheres.csv"), readFile(folder_ / "c/spheres.csv"));
}

TEST_F(FillCommand, FillsUntilFullWhenOnlyARadiusIsGiven)
{
    const Answer answer = run("fill cube --radius 0.45 --frames none --quiet --json");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    EXPECT_EQ(nlohmann::json::parse(answer.output)["outcome"], "full");
}

TEST_F(FillCommand, TakesAPorosityAsOneMinusTheFraction)
{
    const std::string bed = "fill cube --radius 0.1 --count 200 --motion skip --rest joint "
                            "--friction 0.4 --frames none --quiet --overwrite --out bed ";
    const Answer answer = run(bed + "--porosity 0.375 --json");
    EXPECT_EQ(nlohmann::json::parse(answer.output)["scene"]["rest"]["fraction"], 0.625);
    const Answer wrong = run(bed + "--porosity 0.9");
    EXPECT_EQ(wrong.code, 64);
    EXPECT_NE(wrong.errors.find("--fraction (1 minus --porosity) is '0.1'"), std::string::npos)
        << wrong.errors;
    EXPECT_EQ(run(bed + "--porosity 0.375 --fraction 0.625").code, 64);
}

TEST_F(FillCommand, GrainsAreNotLeftInTheNarrowsOfAnAnkle)
{
    const Answer answer = run("fill human --count 120 --seed 1 --motion granular "
                              "--friction 0.3 --frames none --quiet");
    EXPECT_EQ(answer.code, 0) << answer.errors;
}

TEST_F(FillCommand, FillsThroughInletsUntilTheHeapReachesThem)
{
    const std::string inlets = " --inlet '0.3,0.2,0,0.25;-0.3,0.2,0,0.25' --frames none ";
    const Answer answer = run("fill cube --radius 0.2 --quiet --json" + inlets + "--out heap");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto summary = nlohmann::json::parse(answer.output);
    EXPECT_EQ(summary["outcome"], "inlets reached");
    EXPECT_EQ(summary["scene"]["spheres"]["inlets"], "0.3,0.2,0,0.25;-0.3,0.2,0,0.25");
    EXPECT_TRUE(summary["error"]["volume_estimate"].is_null());
    const Answer again = run("fill heap/summary.json --out again");
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_NE(again.output.find("the heap has reached the inlets"), std::string::npos)
        << again.output;
    EXPECT_EQ(again.output.find("until_full"), std::string::npos) << again.output;
    EXPECT_EQ(readFile(folder_ / "heap/spheres.csv"), readFile(folder_ / "again/spheres.csv"));
    for (const auto& [value, says] :
         std::vector<std::pair<std::string, std::string>>{{"0,0,0", "X,Y,Z,RADIUS"},
                                                          {"0,0,0,0", "above 0"},
                                                          {"0,0,0,0.3;", "semicolons"},
                                                          {"here", "none"},
                                                          {"0,5,0,0.3", "not inside"},
                                                          {"0,0,0,0.1", "narrower"}})
    {
        const Answer wrong =
            run("fill cube --radius 0.2 --frames none --out wrong --inlet '" + value + "'");
        EXPECT_EQ(wrong.code, 64) << value;
        EXPECT_NE(wrong.errors.find(says), std::string::npos) << value << ": " << wrong.errors;
    }
}

TEST_F(FillCommand, TellsThatItsDirectoryCannotBeCreated)
{
    writeFile(folder_ / "file", "");
    EXPECT_EQ(run(kEightInTwos + "--frames none --out file").code, 73);
    EXPECT_EQ(run(kEightInTwos + "--frames none --out file/inner").code, 73);
    EXPECT_EQ(run(kEightInTwos + "--frames none --out /proc/no").code, 73);
    if (geteuid() != 0)
    {
        std::filesystem::create_directory(folder_ / "locked");
        std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::owner_read |
                                                             std::filesystem::perms::owner_exec);
        EXPECT_EQ(run(kEightInTwos + "--frames none --out locked").code, 73);
        std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::owner_all);
    }
}

TEST_F(FillCommand, TellsThatTheDiskIsFull)
{
    std::filesystem::create_directory(folder_ / "full");
    std::filesystem::create_symlink("/dev/full", folder_ / "full/sets.csv.part");
    const Answer answer = run(kEightInTwos + "--frames none --quiet --overwrite --out full");
    EXPECT_EQ(answer.code, 0) << "the part of an earlier run is replaced: " << answer.errors;
    EXPECT_EQ(run(kEightInTwos + "--frames none --out b >/dev/full").code, 74);
    EXPECT_EQ(run(kEightInTwos + "--frames none --out c --json >/dev/full").code, 74);
}

TEST_F(FillCommand, BlankPicturesFailWith70AndKeepTheFiles)
{
    const Answer answer =
        run(kEightInTwos + "--size 64x48 --set frames.limit=2 --set camera.target=1e6,0,0 --quiet");
    EXPECT_EQ(answer.code, 70);
    EXPECT_NE(answer.errors.find("blank"), std::string::npos) << answer.errors;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "output/cube/spheres.csv"));
}

TEST_F(FillCommand, StopsWith75WhenAskedToAndWritesEverything)
{
    // The shell sends the signal a moment after the start; the run would take far longer.
    const Answer answer = run("fill cube --count 20000 --frames none --quiet --out a & "
                              "process=$!; until test -d a; do sleep 0.05; done; sleep 0.5; "
                              "kill -TERM $process; wait $process");
    EXPECT_EQ(answer.code, 75) << answer.errors;
    const auto summary =
        nlohmann::json::parse(readFile(folder_ / "a/summary.json"), nullptr, false);
    ASSERT_TRUE(summary.is_object());
    EXPECT_EQ(summary["outcome"], "stopped");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a/spheres.csv"));
}

TEST_F(FillCommand, MakesPassesAndTurntableOfTheSameFrames)
{
    const Answer answer =
        run(kEightInTwos + "--size 64x48 --set frames.limit=3 --set frames.hold=0.2 --turntable 1 "
                           "--set frames.passes=all --background none "
                           "--style dark --color-by speed --cutaway wedge:0,90 "
                           "--set picture.ambient_occlusion=true --set picture.supersample=2 --set "
                           "picture.backend=osmesa");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto frames = [&](const char* folder)
    {
        std::size_t count = 0;
        for (const auto& entry :
             std::filesystem::directory_iterator(folder_ / "output/cube" / folder))
        {
            count += entry.path().extension() == ".png" ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(frames("frames"), 1U);
    for (const char* folder : {"depth", "normal", "identity"})
    {
        EXPECT_EQ(frames(folder), frames("frames")) << folder;
    }
    EXPECT_EQ(run(kEightInTwos + "--size 64x48 --set frames.limit=2 --overwrite").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "output/cube/depth"));
}

TEST_F(FillCommand, LosesNoFrameWhenTheVideoFails)
{
    std::filesystem::create_directory(folder_ / "bin");
    writeFile(folder_ / "bin/ffmpeg", "#!/bin/sh\necho broken >&2\nexit 1\n");
    std::filesystem::permissions(folder_ / "bin/ffmpeg", std::filesystem::perms::owner_all);
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path).c_str(), 1);
    const Answer broken = run(kEightInTwos + "--size 64x48 --set frames.limit=4 --video film.mp4");
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(broken.code, 74) << broken.errors;
    EXPECT_NE(broken.errors.find("broken"), std::string::npos) << broken.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "film.mp4"));
    EXPECT_GT(test::filesIn(folder_ / "output/cube/frames").size(), 1U);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "output/cube/summary.json"));

    EXPECT_EQ(run(kEightInTwos + "--frames none --video film.mp4 --overwrite").code, 64);
    EXPECT_EQ(run(kEightInTwos + "--video film.avi --overwrite").code, 64);
    EXPECT_EQ(run(kEightInTwos + "--set picture.backend=vulkan --overwrite").code, 64);
}

} // namespace
} // namespace frostfill
