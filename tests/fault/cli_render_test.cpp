// SPDX-License-Identifier: MIT
// The command render, as its user meets it.
#include "fault/program.hpp"
#include "fault/run_file_bytes.hpp"
#include "support/picture_files.hpp"
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
using test::writeFile;

const std::string kLonger = "fill cube --radius 0.3 --count 8 --quiet --out run ";
const std::string kShort = kLonger + "--size 64x48 --duration 0.5 ";

class RenderCommand : public ::testing::Test
{
protected:
    RenderCommand() { EXPECT_EQ(run(kShort).code, 0); }
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    [[nodiscard]] std::string picture(const std::string& folder, int number) const
    {
        return readFile(folder_ / folder / fmt::format("frames/frame_{:05}.png", number));
    }
    test::TemporaryFolder folder_;
};

TEST_F(RenderCommand, DrawsBesideTheRunWhatFillHasDrawn)
{
    const Answer answer = run("render run");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.output.find("run/render"), std::string::npos) << answer.output;
    EXPECT_EQ(picture("run/render", 3), picture("run", 3));
    EXPECT_FALSE(picture("run", 3).empty());
    const Answer again = run("render run/run.frost --skip-existing --json");
    EXPECT_EQ(again.code, 0) << again.errors;
    const auto json = nlohmann::json::parse(again.output);
    EXPECT_GT(json["frames"], 10);
    EXPECT_EQ(json["skipped_frames"], json["frames"]);
}

TEST_F(RenderCommand, TakesEveryOptionOfPicturesAndNoneOfTheRun)
{
    const std::string help = run("render --help").output;
    for (const char* option :
         {"--frames", "--size", "--style", "--color-by", "--cutaway", "--no-legend", "--no-shell",
          "--azimuth", "--zoom", "--turntable", "--video", "--set", "--overwrite",
          "--skip-existing", "--json", "--quiet"})
    {
        EXPECT_NE(help.find(option), std::string::npos) << option;
    }
    for (const char* option : {"--count", "--radius", "--duration", "--seed"})
    {
        EXPECT_EQ(help.find(option), std::string::npos) << option;
    }
    const std::string all = run("render --help-all").output;
    for (const char* key : {"frames.fps", "frames.limit", "picture.samples", "camera.path"})
    {
        EXPECT_NE(all.find(key), std::string::npos) << key;
    }
    for (const char* key : {"frames.slow_motion", "spheres.count", "motion.dt"})
    {
        EXPECT_EQ(all.find(key), std::string::npos) << key;
    }
    const Answer answer = run("render run --frames 2..4,last --size 80x60 --style dark --color-by "
                              "speed --set frames.passes=all "
                              "--set picture.supersample=2 --cutaway plane:1,0,0 --set "
                              "frames.hold=0.1 --out other");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_FALSE(picture("other", 4).empty());
    EXPECT_EQ(test::filesIn(folder_ / "other/frames").size(), 6U);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "other/depth/frame_00002.png"));
}

TEST_F(RenderCommand, MakesOnePictureOfTheLastFrameWhereAPngIsNamed)
{
    const Answer answer = run("render run --out cover.png");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("implies --frames last"), std::string::npos) << answer.errors;
    ASSERT_EQ(run("render run --frames last --out last").code, 0);
    const auto last = test::pictures(folder_ / "last");
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(readFile(folder_ / "cover.png"), readFile(last[0]));
    EXPECT_EQ(run("render run --frames 2 --out cover.png").code, 73) << "it is there already";
    const Answer second = run("render run --frames 2 --out cover.png --overwrite");
    EXPECT_EQ(second.code, 0) << second.errors;
    EXPECT_EQ(readFile(folder_ / "cover.png"), picture("run", 2));
    EXPECT_FALSE(std::filesystem::exists(folder_ / ".cover.png.frames"));
}

TEST_F(RenderCommand, RefusesInASentenceWhatItCannotDraw)
{
    ASSERT_EQ(run("render run --out there").code, 0);
    writeFile(folder_ / "text", "solid cube");
    std::filesystem::create_directory(folder_ / "empty");
    std::filesystem::create_directory(folder_ / "begun");
    writeFile(folder_ / "begun/run.frost", readFile(folder_ / "run/run.frost").substr(0, 300));
    struct Case
    {
        std::string arguments;
        int code;
        std::string says;
    };
    const std::vector<Case> cases = {
        {"render", 64, "RUN"},
        {"render nowhere", 66, "run.frost"},
        {"render empty", 66, "run.frost"},
        {"render text --out new", 65, "is no run file"},
        {"render begun --out new", 65, "killed as it began"},
        {"render run --out there", 73, "--overwrite"},
        {"render run --out run --overwrite", 64, "the directory of the run itself"},
        {"render run --frames none --out new", 64, "nothing to draw"},
        {"render run --frames 900..950 --out new", 64, "leaves no frame"},
        {"render run --set picture.samples=64 --out new", 64, "picture.samples is '64'"},
        {"render run --set spheres.count=9 --out new", 64, "does not use the key spheres.count"},
        {"render run --out new.html", 64, "frostfill view run --out new.html"},
        {"render run --out new.png --frames 2..3", 64, "one picture"},
        {"render run --out new.png --turntable 2", 64, "one picture"},
        {"render run --out new.png --shard 1/2", 64, "give a folder"},
        {"render run --count 9 --out new", 64, "--count"},
        {"render run --overwrite --skip-existing --out there", 64, "omit one"},
        {"render run --turntable 2 --set camera.path=0:1,2 --out new", 64, "omit one"},
    };
    for (const Case& each : cases)
    {
        const Answer answer = run(each.arguments);
        EXPECT_EQ(answer.code, each.code) << each.arguments << answer.errors;
        EXPECT_NE(answer.errors.find(each.says), std::string::npos)
            << each.arguments << ": " << answer.errors;
    }
    EXPECT_FALSE(picture("run", 0).empty());
    EXPECT_FALSE(picture("there", 0).empty());
}

TEST_F(RenderCommand, SaysThatAFileIsTornAndDrawsWhatIsWhole)
{
    ASSERT_EQ(run(kLonger + "--overwrite --size 64x48 --duration 3").code, 0);
    const std::string whole = readFile(folder_ / "run/run.frost");
    writeFile(folder_ / "run/run.frost",
              test::withoutSummary(whole).substr(0, test::withoutSummary(whole).size() - 9));
    const Answer answer = run("render run");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("is incomplete"), std::string::npos) << answer.errors;
    EXPECT_EQ(picture("run/render", 3), picture("run", 3));
}

TEST_F(RenderCommand, StopsWith75WhenAskedToAndSkipsWhatIsThere)
{
    ASSERT_EQ(run(kLonger + "--overwrite --duration 8 --size 320x240").code, 0);
    // Asked to at its first picture; all of them take far longer.
    const Answer stopped =
        run("render run --size 1920x1440 --quiet & process=$!; "
            "until test -e run/render/frames/frame_00000.png; do sleep 0.01; done; "
            "kill -TERM $process; wait $process");
    EXPECT_EQ(stopped.code, 75) << stopped.errors;
    EXPECT_FALSE(picture("run/render", 0).empty());
    EXPECT_TRUE(picture("run/render", 239).empty());
}

TEST_F(RenderCommand, GoesOnAfterAKill)
{
    ASSERT_EQ(run(kLonger + "--overwrite --duration 8 --size 320x240").code, 0);
    (void)run("render run --quiet & process=$!; sleep 0.7; kill -KILL $process; wait $process");
    ASSERT_EQ(run("render run --quiet --skip-existing").code, 0);
    for (int k = 0; !picture("run", k).empty(); ++k)
    {
        EXPECT_TRUE(picture("run", k) == picture("run/render", k)) << k;
    }
}

} // namespace
} // namespace frostfill
