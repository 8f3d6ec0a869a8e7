// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/load_png.hpp"
#include "support/small_runs.hpp"

#include <frostfill/image.hpp>

#include <gtest/gtest.h>

// Options about frames, several at once.
namespace frostfill
{
namespace
{

using test::picture;
using test::pictureText;
using test::TemporaryFolder;

FillRequest smallFill(const std::filesystem::path& folder)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = 40;
    return test::smallPictures(scene, folder);
}

TEST(FrameOptions, TheLastFrameAloneIsHeldAndTurnedWithoutTheFall)
{
    const TemporaryFolder folder;
    FillRequest request = smallFill(folder / "run");
    request.scene.frames.selection = "last";
    request.scene.camera.turntable = 0.4;
    request.scene.frames.passes.depth = true;
    const FillResult result = fill(request);
    EXPECT_EQ(result.frames, 12U) << "one turn";
    const std::string state = test::stateOf(nlohmann::json::parse(result.summary));
    for (std::size_t i = 0; i < result.frames; ++i)
    {
        EXPECT_EQ(pictureText(picture(folder / "run", i), "State"), state);
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "run/depth/frame_00011.png"));
    EXPECT_NE(loadPng(picture(folder / "run", 0)).pixels,
              loadPng(picture(folder / "run", 4)).pixels)
        << "it turns";

    request.overwrite = true;
    request.scene.frames.hold = 0.1;
    EXPECT_EQ(fill(request).frames, 3U);
    request.scene.camera.turntable.reset();
    request.scene.frames.hold = 0;
    EXPECT_EQ(fill(request).frames, 1U);
}

TEST(FrameOptions, ListedFramesAreAnnouncedAndKeptOneByOne)
{
    const TemporaryFolder folder;
    FillRequest request = smallFill(folder / "run");
    request.scene.frames.duration = 2;
    request.scene.frames.selection = "0..20:10,33,last";
    FillPlan plan;
    FillObserver observer;
    observer.planned = [&](const FillPlan& announced) { plan = announced; };
    const FillResult result = fill(request, observer);
    EXPECT_EQ(plan.frames, 5U);
    EXPECT_EQ(result.frames, 5U);
    for (const std::size_t number : {0U, 10U, 20U, 33U})
    {
        EXPECT_EQ(pictureText(picture(folder / "run", number), "Frame"), std::to_string(number));
    }
    const auto summary = nlohmann::json::parse(result.summary);
    EXPECT_EQ(pictureText(test::pictures(folder / "run").back(), "State"), test::stateOf(summary));
    EXPECT_TRUE(summary["slow_motion"].is_null()) << "there is no one speed";
}

TEST(FrameOptions, AskingForFramesAfterTheEndIsRefusedBeforeAnythingIsWritten)
{
    const TemporaryFolder folder;
    FillRequest request = smallFill(folder / "run");
    request.scene.frames.duration = 1;
    request.scene.frames.selection = "500..600";
    test::expectError(
        ErrorCode::usage, [&] { (void)fill(request); }, "leaves no frame");
    EXPECT_FALSE(std::filesystem::exists(folder / "run/summary.json"));
}

TEST(FrameOptions, ASinglePictureIsThatOfTheEnd)
{
    const TemporaryFolder folder;
    FillRequest request = smallFill(folder / "run");
    request.scene.frames.limit = 1;
    const FillResult result = fill(request);
    ASSERT_EQ(result.frames, 1U);
    EXPECT_EQ(pictureText(picture(folder / "run", 0), "State"),
              test::stateOf(nlohmann::json::parse(result.summary)));
}

// Fewer pictures do not make it faster.
TEST(FrameOptions, AFewPicturesAreSpreadOverTheWholeAnimation)
{
    const TemporaryFolder folder;
    FillRequest request = smallFill(folder / "run");
    request.scene.frames.duration = 10;
    request.scene.frames.limit = 40;
    const FillResult result = fill(request);
    EXPECT_LE(result.frames, 40U);
    EXPECT_GE(result.frames, 34U);
    const auto summary = nlohmann::json::parse(result.summary);
    EXPECT_NEAR(static_cast<double>(result.frames) / summary["frames_per_second"].get<double>(), 10,
                0.6);
}

} // namespace
} // namespace frostfill
