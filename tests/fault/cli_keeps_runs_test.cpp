// SPDX-License-Identifier: MIT
// What was written already is not lost: by a run that cannot begin, by two signals at once, by two
// runs in one directory.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;

const std::string kEightSpheres =
    "fill cube --radius 0.3 --count 8 --set spheres.group_size=2 --size 64x48 ";

// A shell's words that wait until a run has made its directory, just before it locks it.
std::string waitFor(const std::string& directory)
{
    return "until test -d " + directory + "; do sleep 0.05; done; sleep 0.3; ";
}

// Takes far longer than any test waits.
const std::string kLongWithoutPictures =
    "fill cube --count 200000 --frames none --quiet --set threads=1 ";

class KeepsRuns : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(KeepsRuns, ARunThatCannotBeginLeavesTheOldOneAsItIs)
{
    ASSERT_EQ(run(kEightSpheres + "--out keep --set frames.limit=2").code, 0);
    const std::string before = readFile(folder_ / "keep/summary.json");
    const std::string picture = readFile(folder_ / "keep/frames/frame_00000.png");
    ASSERT_FALSE(picture.empty());
    const std::string again = kEightSpheres + "--out keep --overwrite ";
    EXPECT_EQ(run(again + "--set picture.samples=64").code, 64);
    EXPECT_EQ(run(again + "--size 16384x16384 --set picture.supersample=8").code, 64);
    EXPECT_EQ(run(again + "--video /nonexistent/a.mp4").code, 73);
    EXPECT_EQ(readFile(folder_ / "keep/summary.json"), before);
    EXPECT_EQ(readFile(folder_ / "keep/frames/frame_00000.png"), picture);
    EXPECT_EQ(run(again + "--set frames.limit=2 --seed 2").code, 0);
    EXPECT_NE(readFile(folder_ / "keep/summary.json"), before);
}

TEST_F(KeepsRuns, SignalsThatComeTogetherStopTheRunAndLoseNothing)
{
    for (const std::string& signal : std::vector<std::string>{"TERM", "INT", "HUP"})
    {
        const Answer answer = run(
            fmt::format("{0}--out {1} & process=$!; {2}kill -{1} $process; kill -TERM $process; "
                        "kill -{1} $process; wait $process",
                        kLongWithoutPictures, signal, waitFor(signal)));
        EXPECT_EQ(answer.code, 75) << signal << answer.errors;
        const auto summary =
            nlohmann::json::parse(readFile(folder_ / signal / "summary.json"), nullptr, false);
        ASSERT_TRUE(summary.is_object()) << signal;
        EXPECT_EQ(summary["outcome"], "stopped");
    }
}

TEST_F(KeepsRuns, ASecondRunInTheSameDirectoryIsRefused)
{
    const Answer answer =
        run(kLongWithoutPictures + "--out a & process=$!; " + waitFor("a") +
            "'" FROSTFILL_PROGRAM "' fill cube --count 4 --frames none --overwrite --out a; "
            "second=$?; kill -TERM $process; wait $process; "
            "test $? -eq 75 && exit $second");
    EXPECT_EQ(answer.code, 73);
    EXPECT_NE(answer.errors.find("another run is writing to a"), std::string::npos)
        << answer.errors;
}

} // namespace
} // namespace frostfill
