// SPDX-License-Identifier: MIT
// Several processes draw the pictures of one run.
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/render_run.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace frostfill
{
namespace
{

using test::expectError;
using test::filesIn;
using test::readFile;

class RenderShards : public ::testing::Test
{
protected:
    RenderShards()
    {
        FillRequest request;
        request.scene = presetScene(Preset::fast, "torus");
        request.scene.spheres.count = 30;
        request.scene.size = {96, 72};
        request.scene.frames.duration = 1.3;
        request.scene.frames.enabled = false;
        request.scene.frames.keepRun = true;
        request.directory = folder_ / "run";
        EXPECT_FALSE(fill(request).failure);
    }
    [[nodiscard]] RenderRequest into(const char* directory) const
    {
        RenderRequest request;
        request.run = folder_ / "run";
        request.directory = folder_ / directory;
        request.change = change_;
        return request;
    }
    /// Draws the parts in some order; returns how many pictures they were.
    std::size_t drawParts(std::size_t count, unsigned seed = 1) const
    {
        std::vector<std::size_t> order(count);
        for (std::size_t i = 0; i < count; ++i)
        {
            order[i] = i;
        }
        std::shuffle(order.begin(), order.end(), std::mt19937(seed));
        std::size_t pictures = 0;
        for (const std::size_t index : order)
        {
            RenderRequest request = into("parts");
            request.shard = {index, count};
            pictures += renderRun(request).frames;
        }
        return pictures;
    }
    /// Sixteen parts in any order have the bytes of one process.
    void expectTheSameBytes()
    {
        const std::size_t all = renderRun(into("one")).frames;
        EXPECT_EQ(drawParts(16), all);
        const auto one = filesIn(folder_ / "one");
        const auto parts = filesIn(folder_ / "parts");
        EXPECT_GE(one.size(), 1U);
        EXPECT_TRUE(one == parts) << one.size() << " files, and " << parts.size();
        RenderRequest look = into("parts");
        look.gather = true;
        const RenderResult gathered = renderRun(look);
        EXPECT_EQ(gathered.missing, std::vector<std::size_t>{});
        EXPECT_EQ(gathered.allFrames, all);
        EXPECT_EQ(gathered.surplus, 0U);
        std::filesystem::remove_all(folder_ / "one");
        std::filesystem::remove_all(folder_ / "parts");
    }
    std::function<void(Scene&)> change_;
    test::TemporaryFolder folder_;
};

TEST_F(RenderShards, InAnyOrderHaveTheBytesOfOneProcess)
{
    expectTheSameBytes();
}

TEST_F(RenderShards, HaveThemForThinnedHeldAndSelectedFramesAndFewerThanParts)
{
    change_ = [](Scene& scene)
    {
        scene.frames.limit = 7;
        scene.frames.hold = 0.4;
    };
    expectTheSameBytes();
    change_ = [](Scene& scene) { scene.frames.selection = "2..30:3,last"; };
    expectTheSameBytes();
    change_ = [](Scene& scene) { scene.frames.selection = "last"; };
    expectTheSameBytes();
}

TEST_F(RenderShards, HaveThemWithPassesATurntableAndAnotherStyle)
{
    change_ = [](Scene& scene)
    {
        scene.frames.passes.depth = true;
        scene.frames.passes.identity = true;
        scene.camera.turntable = 0.7;
        scene.style.colourBy = "set";
    };
    expectTheSameBytes();
}

TEST_F(RenderShards, TellWhichPicturesAreNotThereUntilTheyAre)
{
    RenderRequest part = into("parts");
    part.shard = {0, 2};
    const std::size_t half = renderRun(part).frames;
    part.shard = {1, 2};
    const std::size_t rest = renderRun(part).frames;
    const std::filesystem::path frames = folder_ / "parts/frames";
    std::filesystem::remove(frames / "frame_00002.png");
    std::filesystem::copy_file(frames / "frame_00006.png", frames / "frame_00005.png",
                               std::filesystem::copy_options::overwrite_existing);
    RenderRequest look = into("parts");
    look.gather = true;
    RenderResult gathered = renderRun(look);
    EXPECT_EQ(gathered.missing, (std::vector<std::size_t>{2, 5}));
    EXPECT_EQ(gathered.allFrames, half + rest);
    EXPECT_FALSE(std::filesystem::exists(frames / "frame_00002.png"));

    part.shard = {0, 2};
    EXPECT_EQ(renderRun(part).skippedFrames, half - 2); // as after a kill
    gathered = renderRun(look);
    EXPECT_EQ(gathered.missing, std::vector<std::size_t>{});

    std::filesystem::copy_file(frames / "frame_00000.png", frames / "frame_09999.png");
    EXPECT_EQ(renderRun(look).surplus, 1U);
}

TEST_F(RenderShards, RemoveNothingThatOthersAreWriting)
{
    drawParts(2);
    const std::filesystem::path other = folder_ / "parts/frames/frame_00003.png.4711.tmp";
    test::writeFile(other, "half a picture");
    drawParts(2);
    EXPECT_TRUE(std::filesystem::exists(other));
}

TEST_F(RenderShards, RefuseWhatOnlyOneProcessCanDo)
{
    RenderRequest part = into("parts");
    part.shard = {0, 2};
    part.overwrite = true;
    expectError(
        ErrorCode::usage, [&] { (void)renderRun(part); }, "--overwrite");
    part.overwrite = false;
    RenderRequest look = into("nowhere");
    look.gather = true;
    expectError(
        ErrorCode::inputMissing, [&] { (void)renderRun(look); }, "no pictures to gather");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "nowhere"));
}

TEST_F(RenderShards, AreCountedWithoutWritingAnything)
{
    RenderRequest dry = into("parts");
    dry.dryRun = true;
    dry.shard = {1, 16};
    const RenderResult plan = renderRun(dry);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "parts"));
    dry.dryRun = false;
    const RenderResult drawn = renderRun(dry);
    EXPECT_EQ(plan.frames, drawn.frames);
    EXPECT_EQ(plan.allFrames, drawn.allFrames);
}

} // namespace
} // namespace frostfill
