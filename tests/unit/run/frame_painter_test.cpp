// SPDX-License-Identifier: MIT
// Every n-th picture of a run: each has the number of its frame, and is what a renderer draws that
// has drawn nothing before.
#include "run/frame_painter.hpp"

#include "support/load_png.hpp"
#include "support/small_runs.hpp"

#include <frostfill/image.hpp>

#include <gtest/gtest.h>

#include <deque>

namespace frostfill
{
namespace
{

/// A sphere that sinks slowly, so that few rows change; every third state repeats the one before.
Snapshot stateOf(std::size_t frame)
{
    Snapshot snapshot;
    snapshot.resize(1);
    const auto sunk = static_cast<float>(frame - frame % 3 / 2);
    snapshot.centres[0] = {0, 0.4F - 0.02F * sunk, 0};
    snapshot.radii[0] = 0.2F;
    snapshot.running = 1;
    snapshot.time = static_cast<double>(frame);
    return snapshot;
}

TEST(FramePainter, KeepsTheNumbersWhereOthersAreLeftOut)
{
    for (const std::size_t stride : {2U, 3U, 6U})
    {
        const test::TemporaryFolder folder;
        Scene scene = presetScene(Preset::fast, "cube");
        scene.size = {48, 64};
        scene.frames.passes.depth = true;
        const TriangleMesh mesh = loadMesh(scene.object.mesh, scene.object.load).mesh;
        const PaintRequest request{mesh, scene, {}, {}, "run", folder.path(), {}, {}};
        std::deque<Snapshot> states;
        FramePainter painter(request);
        painter.plan().keepEvery(stride);
        constexpr std::size_t kFrames = 29;
        for (std::size_t frame = 0; frame < kFrames; ++frame)
        {
            states.push_back(stateOf(frame));
            states.back().revision = frame;
            painter.plan().wants(frame) ? painter.take(frame, states.back())
                                        : painter.plan().pass(frame);
        }
        painter.finish(kFrames, &states.back());

        std::vector<std::size_t> numbers;
        for (const std::filesystem::path& file : test::pictures(folder.path()))
        {
            numbers.push_back(std::stoul(test::pictureText(file, "Frame")));
            EXPECT_EQ(file.filename(), PngSequence::fileName(numbers.back()));
            EXPECT_TRUE(std::filesystem::exists(folder / "depth" / file.filename()));
            Image alone;
            Renderer(mesh, renderSettings(scene))
                .render(states.at(std::min(numbers.back(), kFrames - 1)), alone);
            EXPECT_TRUE(loadPng(file).pixels == alone.pixels) << stride << " " << numbers.back();
        }
        EXPECT_EQ(painter.drawn().numbers, numbers);
        EXPECT_LE(numbers.size(), kFrames / stride + 2);
        EXPECT_EQ(test::filesIn(folder / "depth").size(), numbers.size());
        for (std::size_t i = 1; i + 1 < numbers.size(); ++i)
        {
            EXPECT_EQ(numbers[i], i * stride);
        }
    }
}

} // namespace
} // namespace frostfill
