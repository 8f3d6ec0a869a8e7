// SPDX-License-Identifier: MIT
// Numbers of frames, as a user meets them: whatever is written is accepted, and means the same.
#include "fault/program.hpp"
#include "support/picture_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::filesIn;
using test::pictureText;
using test::readFile;

const std::string kSmall = "fill torus --count 30 --size 64x48 --set picture.samples=1 --duration "
                           "1 --set threads=1 --quiet ";

class FrameNumbers : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    [[nodiscard]] std::set<std::string> names(const std::string& directory) const
    {
        std::set<std::string> all;
        for (const auto& [name, bytes] : filesIn(folder_ / directory / "frames"))
        {
            all.insert(name);
        }
        return all;
    }
    /// The number of the last state, which is the last one of the page.
    [[nodiscard]] std::size_t lastOnPage(const std::string& directory) const
    {
        const std::string page = readFile(folder_ / directory / "view.html");
        const std::string key = "\"frames\":[";
        const std::size_t at = page.find(key);
        const std::string list = page.substr(at + key.size(), page.find(']', at) - at - key.size());
        return std::stoul(list.substr(list.rfind(',') + 1));
    }
    void expectEachIsDrawnAgain(const std::string& directory, const std::string& with,
                                const std::vector<std::size_t>& numbers) const
    {
        for (const std::size_t number : numbers)
        {
            const Answer answer =
                run(fmt::format("render {} --frames {} {} --quiet --overwrite --out again",
                                directory, number, with));
            EXPECT_EQ(answer.code, 0) << number << answer.errors;
            const std::string name = fmt::format("frames/frame_{:05}.png", number);
            EXPECT_EQ(names("again").size(), 1U) << number;
            EXPECT_EQ(pictureText(folder_ / "again" / name, "Frame"), std::to_string(number));
            EXPECT_TRUE(readFile(folder_ / "again" / name) == readFile(folder_ / directory / name))
                << number;
        }
    }
    test::TemporaryFolder folder_;
};

TEST_F(FrameNumbers, OfFilesTextAndPageAreAllTaken)
{
    ASSERT_EQ(run(kSmall + "--out run").code, 0);
    ASSERT_EQ(run("view run --quiet").code, 0);
    const std::size_t last = lastOnPage("run");
    EXPECT_EQ(*names("run").rbegin(), fmt::format("frame_{:05}.png", last));
    expectEachIsDrawnAgain("run", "", {0, 7, last - 1, last});
    const Answer some =
        run(fmt::format("render run --frames {}..{} --quiet --out some", last - 4, last));
    EXPECT_EQ(some.code, 0) << some.errors;
    EXPECT_EQ(names("some").size(), 5U);
    ASSERT_EQ(run("render run --frames last --quiet --out poster").code, 0);
    const auto poster = test::pictures(folder_ / "poster");
    ASSERT_EQ(poster.size(), 1U);
    EXPECT_EQ(pictureText(poster[0], "Frame"), std::to_string(last));
    EXPECT_EQ(poster[0].filename(), fmt::format("frame_{:05}.png", last));
    // And in a run of its own.
    ASSERT_EQ(run(kSmall + fmt::format("--frames {} --out alone", last)).code, 0);
    EXPECT_EQ(names("alone"), (std::set{fmt::format("frame_{:05}.png", last)}));
}

TEST_F(FrameNumbers, OfAVideoOnStandardOutputAreThoseOfThePicturesAndNothingElseIsThere)
{
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
    {
        GTEST_SKIP() << "there is no ffmpeg";
    }
    const std::string sums = "-pix_fmt rgb24 -f rawvideo - | md5sum";
    const Answer video = run("fill torus --count 30 --size 64x48 --duration 1 --out run --video - "
                             "| ffmpeg -v error -i - " +
                             sums);
    EXPECT_EQ(video.code, 0) << video.errors;
    EXPECT_NE(video.errors.find("results in run"), std::string::npos) << video.errors;
    ASSERT_GT(names("run").size(), 10U);
    const std::string pictures = "'" + folder_.path().string() + "/run/frames/frame_%05d.png' ";
    const Answer same =
        test::runProgram("-v error -i " + pictures + sums, folder_.path(), "", "ffmpeg");
    EXPECT_EQ(video.output, same.output) << same.errors;
}

TEST_F(FrameNumbers, OfHeldThinnedAndTurnedFramesAreTakenToo)
{
    ASSERT_EQ(run(kSmall + "--set frames.hold=0.3 --set frames.limit=7 --set frames.passes=depth "
                           "--out run")
                  .code,
              0);
    const std::set<std::string> pictures = names("run");
    EXPECT_LE(pictures.size(), 7U);
    std::vector<std::size_t> numbers;
    for (const std::string& name : pictures)
    {
        EXPECT_EQ(pictureText(folder_ / "run/frames" / name, "Frame"),
                  std::to_string(std::stoul(name.substr(6))));
        EXPECT_TRUE(std::filesystem::exists(folder_ / "run/depth" / name)) << name;
        numbers.push_back(std::stoul(name.substr(6)));
    }
    expectEachIsDrawnAgain("run", "", numbers);

    ASSERT_EQ(run(kSmall + "--frames last --turntable 0.4 --out turn").code, 0);
    EXPECT_EQ(names("turn").size(), 12U);
    expectEachIsDrawnAgain("turn", "", {0, 1, 11});
    ASSERT_EQ(run("render run --frames last --set frames.hold=0 --set frames.limit=0 --turntable "
                  "0.4 --quiet --out round")
                  .code,
              0);
    const auto round = test::pictures(folder_ / "round");
    ASSERT_EQ(round.size(), 12U);
    const std::size_t first = std::stoul(pictureText(round[0], "Frame"));
    for (const std::size_t number : {first, first + 7})
    {
        const std::string name = fmt::format("frames/frame_{:05}.png", number);
        const Answer one = run(fmt::format("render run --frames {} --set frames.hold=0 --turntable "
                                           "0.4 --quiet --overwrite --out one",
                                           number));
        EXPECT_EQ(one.code, 0) << one.errors;
        EXPECT_TRUE(readFile(folder_ / "one" / name) == readFile(folder_ / "round" / name));
    }
}

TEST_F(FrameNumbers, LetTwoRangesShareAFolder)
{
    ASSERT_EQ(run(kSmall + "--out run").code, 0);
    ASSERT_EQ(run("render run --frames 3..5 --quiet --out part").code, 0);
    ASSERT_EQ(run("render run --frames 8,11 --quiet --skip-existing --out part").code, 0);
    EXPECT_EQ(names("part"),
              (std::set<std::string>{"frame_00003.png", "frame_00004.png", "frame_00005.png",
                                     "frame_00008.png", "frame_00011.png"}));
}

TEST_F(FrameNumbers, BeyondTheLastAreAnError)
{
    ASSERT_EQ(run(kSmall + "--out run").code, 0);
    ASSERT_EQ(run("view run --quiet").code, 0);
    const std::size_t last = lastOnPage("run");
    for (const std::string& frames :
         {std::to_string(last + 1), fmt::format("{}..{}", last + 1, last + 9), std::string("5000")})
    {
        const Answer again = run("render run --out again --frames " + frames);
        EXPECT_EQ(again.code, 64) << again.errors;
        EXPECT_NE(again.errors.find(fmt::format("numbers 0 to {}", last)), std::string::npos)
            << again.errors;
        const Answer anew = run(kSmall + "--overwrite --out anew --frames " + frames);
        EXPECT_EQ(anew.code, 64) << frames << anew.errors;
        EXPECT_NE(anew.errors.find("leaves no frame"), std::string::npos) << anew.errors;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "again"));
}

TEST_F(FrameNumbers, OfTheLastIsOnePictureUnlessTheCommandTurnsTheObject)
{
    ASSERT_EQ(run(kSmall + "--turntable 0.5 --out run").code, 0);
    ASSERT_EQ(run("render run --frames last --quiet --out poster").code, 0);
    ASSERT_EQ(names("poster").size(), 1U);
    const std::string name = *names("poster").begin();
    EXPECT_EQ(name, *names("run").rbegin());
    EXPECT_TRUE(readFile(folder_ / "poster/frames" / name) ==
                readFile(folder_ / "run/frames" / name));
    ASSERT_EQ(run("render run --frames last --turntable none --quiet --out still").code, 0);
    EXPECT_EQ(names("still").size(), 1U);
    ASSERT_EQ(run("render run --frames last --turntable 0.5 --quiet --out turn").code, 0);
    EXPECT_EQ(names("turn").size(), 15U);
}

// Nothing is seen before the first sphere appears.
TEST_F(FrameNumbers, BeforeTheFirstSphereShowNoBlankPictures)
{
    const std::string early =
        "fill torus --count 50 --motion skip --no-shell --size 64x48 --quiet ";
    const Answer answer = run(early + "--frames 0..3 --out early");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_EQ(names("early").size(), 4U);
    const Answer blank =
        run(early +
            "--set camera.target=90,0,0 --set camera.distance=3 --frames 0..3,last --out blank");
    EXPECT_EQ(blank.code, 70) << blank.errors;
    EXPECT_NE(blank.errors.find("blank"), std::string::npos) << blank.errors;
}

} // namespace
} // namespace frostfill
