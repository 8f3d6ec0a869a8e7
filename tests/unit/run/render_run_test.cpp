// SPDX-License-Identifier: MIT
// A kept run is drawn again to the same bytes.
#include "run_file/records.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/image.hpp>
#include <frostfill/render_run.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace frostfill
{
namespace
{

using test::expectError;
using test::filesIn;
using test::readFile;
using test::TemporaryFolder;

using Files = std::map<std::string, std::string>;

/// Which of the files differ, or are in one folder only.
std::string difference(const Files& a, const Files& b)
{
    std::string names;
    for (const auto& [name, bytes] : a)
    {
        const auto other = b.find(name);
        names += other == b.end() ? " -" + name : other->second != bytes ? " !" + name : "";
    }
    for (const auto& [name, bytes] : b)
    {
        names += a.contains(name) ? "" : " +" + name;
    }
    return names;
}

class RenderRun : public ::testing::Test
{
protected:
    /// A run of half a second of video.
    FillRequest smallRun(const char* object = "torus", Preset preset = Preset::fast) const
    {
        FillRequest request;
        request.scene = presetScene(preset, object);
        request.scene.spheres.count = 30;
        request.scene.size = {96, 72};
        request.scene.frames.duration = 0.5;
        request.directory = folder_ / "run";
        return request;
    }
    [[nodiscard]] RenderRequest again() const
    {
        RenderRequest request;
        request.run = folder_ / "run";
        request.directory = folder_ / "again";
        return request;
    }
    [[nodiscard]] Files drawn(const char* directory = "run") const
    {
        return filesIn(folder_ / directory / "frames");
    }
    void expectTheSameBytes(const FillRequest& request) const
    {
        const FillResult run = fill(request);
        const RenderResult result = renderRun(again());
        EXPECT_EQ(result.frames, run.frames);
        EXPECT_TRUE(result.ended);
        EXPECT_EQ(difference(drawn(), drawn("again")), "");
        EXPECT_GE(drawn().size(), 2U);
        std::filesystem::remove_all(folder_ / "run");
        std::filesystem::remove_all(folder_ / "again");
    }
    TemporaryFolder folder_;
};

TEST_F(RenderRun, DrawsTheBytesOfEveryObjectMotionAndStyle)
{
    const std::vector<std::string> colours = colourColumns();
    int k = 0;
    for (const char* object : {"torus", "sphere", "cube", "human"})
    {
        for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
        {
            FillRequest request = smallRun(object);
            request.scene.motion.mode = motion;
            request.scene.style.look = static_cast<Look>(k % 4);
            request.scene.style.palette = paletteOf(request.scene.style.look);
            request.scene.style.colourBy = colours[static_cast<std::size_t>(k) % colours.size()];
            SCOPED_TRACE(fmt::format("{} {}", object, k));
            expectTheSameBytes(request);
            ++k;
        }
    }
}

TEST_F(RenderRun, DrawsTheBytesOfThePapersPreset)
{
    expectTheSameBytes(smallRun("cube", Preset::paper));
}

TEST_F(RenderRun, DrawsTheBytesOfMovedObjectsAndOfDifferentRadii)
{
    FillRequest request = smallRun("cube");
    request.scene.spheres.radius = Radii(0.15, 0.3);
    request.scene.move.tilt = 30;
    expectTheSameBytes(request);
}

TEST_F(RenderRun, DrawsTheBytesOfTurntablesPathsAndHeldFrames)
{
    FillRequest request = smallRun();
    request.scene.camera.turntable = 0.4;
    request.scene.frames.hold = 0.2;
    expectTheSameBytes(request);
    request.scene.camera.turntable.reset();
    request.scene.frames.cameraPath = "0:30,20 0.5:120,45,2";
    expectTheSameBytes(request);
}

TEST_F(RenderRun, DrawsTheBytesOfThinnedFramesAndOfTheLastAlone)
{
    FillRequest request = smallRun();
    request.scene.frames.limit = 6;
    expectTheSameBytes(request);
    request.scene.frames.limit = 0;
    request.scene.frames.selection = "2..8:3,last";
    expectTheSameBytes(request);
}

TEST_F(RenderRun, DrawsAFrameTheSameWhicheverOthersAreDrawn)
{
    ASSERT_FALSE(fill(smallRun()).failure);
    const Files all = drawn();
    RenderRequest request = again();
    request.change = [](Scene& scene) { scene.frames.selection = "3..11:4"; };
    EXPECT_EQ(renderRun(request).frames, 3U);
    const Files some = drawn("again");
    for (const char* name : {"frame_00003.png", "frame_00007.png", "frame_00011.png"})
    {
        EXPECT_EQ(some.at(name), all.at(name)) << name;
    }
}

TEST_F(RenderRun, DrawsWhatFillWouldHaveDrawnWithOtherSettings)
{
    FillRequest request = smallRun();
    ASSERT_FALSE(fill(request).failure);
    const auto change = [](Scene& scene)
    {
        scene.camera.azimuth = 75;
        scene.size = {80, 80};
        scene.style.colourBy = "set";
    };
    RenderRequest other = again();
    other.change = change;
    EXPECT_EQ(renderRun(other).frames, drawn().size());
    change(request.scene);
    request.directory = folder_ / "filled";
    ASSERT_FALSE(fill(request).failure);
    EXPECT_EQ(difference(drawn("filled"), drawn("again")), "");
}

TEST_F(RenderRun, DrawsARunThatWasKeptWithoutPictures)
{
    FillRequest request = smallRun();
    request.directory = folder_ / "drawn";
    ASSERT_FALSE(fill(request).failure);
    request.directory = folder_ / "run";
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    ASSERT_FALSE(fill(request).failure);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "run/frames"));
    (void)renderRun(again());
    EXPECT_EQ(difference(drawn("drawn"), drawn("again")), "");
}

TEST_F(RenderRun, KeepingARunChangesNoPictureAndNoState)
{
    FillRequest request = smallRun();
    const FillResult kept = fill(request);
    request.scene.frames.keepRun = false;
    request.directory = folder_ / "again";
    const FillResult without = fill(request);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "run/run.frost"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "again/run.frost"));
    EXPECT_EQ(kept.stateHash, without.stateHash);
    EXPECT_EQ(difference(drawn(), drawn("again")), "");
}

TEST_F(RenderRun, SkipsOnlyPicturesThatAreWholeAndTheRightOnes)
{
    ASSERT_FALSE(fill(smallRun()).failure);
    RenderRequest request = again();
    const std::size_t count = renderRun(request).frames;
    const Files before = drawn("again");
    const std::filesystem::path frames = folder_ / "again/frames";
    std::filesystem::remove(frames / "frame_00002.png");
    std::filesystem::resize_file(frames / "frame_00004.png", 300);
    std::string damaged = before.at("frame_00006.png");
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    test::writeFile(frames / "frame_00006.png", damaged);
    test::writeFile(frames / "frame_00008.png", before.at("frame_00009.png"));
    request.skipExisting = true;
    EXPECT_EQ(renderRun(request).skippedFrames, count - 4);
    EXPECT_EQ(difference(before, drawn("again")), "");

    request.change = [](Scene& scene) { scene.camera.elevation = 60; };
    EXPECT_EQ(renderRun(request).skippedFrames, 0U);
    EXPECT_NE(before.at("frame_00009.png"), drawn("again").at("frame_00009.png"));
}

TEST_F(RenderRun, LeavesOutFallsOnlyWhereTheyAreThere)
{
    FillRequest fallen = smallRun("cube");
    fallen.scene.motion.mode = Motion::descend;
    ASSERT_FALSE(fill(fallen).failure);
    RenderRequest request = again();
    (void)renderRun(request);
    for (const char* name : {"frame_00003.png", "frame_00007.png", "frame_00008.png"})
    {
        std::filesystem::remove(folder_ / "again/frames" / name);
    }
    request.skipExisting = true;
    EXPECT_EQ(renderRun(request).skippedFrames, drawn().size() - 3);
    EXPECT_EQ(difference(drawn(), drawn("again")), "");
}

TEST_F(RenderRun, ReadsATornFileUpToItsLastWholeRecord)
{
    FillRequest request = smallRun();
    request.scene.frames.duration = 3; // more than one record
    ASSERT_FALSE(fill(request).failure);
    const std::filesystem::path file = folder_ / "run/run.frost";
    const std::string whole = readFile(file);
    const std::size_t summary = wholeRecords(whole).back().bytes.size();
    std::filesystem::resize_file(file, whole.size() - summary - sizeof(RecordHeader) - 9);
    const RenderResult result = renderRun(again());
    EXPECT_FALSE(result.ended);
    EXPECT_LT(result.wholeBytes, result.fileBytes);
    EXPECT_EQ(result.frames, result.keptFrames);
    const Files all = drawn();
    for (const auto& [name, bytes] : drawn("again"))
    {
        EXPECT_EQ(bytes, all.at(name)) << name;
    }
}

TEST_F(RenderRun, RefusesWhatCannotBeDrawn)
{
    ASSERT_FALSE(fill(smallRun()).failure);
    RenderRequest request = again();
    request.directory = folder_ / "run";
    request.overwrite = true;
    expectError(
        ErrorCode::usage, [&] { (void)renderRun(request); }, "the directory of the run itself");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "run/run.frost"));
    request = again();
    request.run = folder_ / "nowhere";
    expectError(
        ErrorCode::inputMissing, [&] { (void)renderRun(request); }, "nowhere");
    request = again();
    request.change = [](Scene& scene) { scene.frames.selection = "5000..6000"; };
    expectError(
        ErrorCode::usage, [&] { (void)renderRun(request); }, "5000..6000 leaves no frame");
    EXPECT_EQ(renderRun(again()).frames, drawn().size());
    expectError(
        ErrorCode::cannotCreate, [&] { (void)renderRun(again()); }, "--overwrite");
}

} // namespace
} // namespace frostfill
