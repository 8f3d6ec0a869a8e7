// SPDX-License-Identifier: MIT
#include "run/frame_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

MeshReport meshOfHeight(double height)
{
    MeshReport mesh;
    mesh.box = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, height, 1)};
    return mesh;
}

TEST(FrameTiming, ShowsAFallThroughTheObjectInOneAndAHalfSecondsWhateverItsSize)
{
    for (const double height : {0.15, 2.8, 500.0})
    {
        const Scene scene = presetScene(Preset::paper, "torus");
        const FrameTiming timing = frameTiming(scene, meshOfHeight(height));
        const double fall = std::sqrt(2 * height / 9.81);
        EXPECT_NEAR(fall / timing.interval, 1.5 * 30, 1e-9);
        EXPECT_NEAR(timing.slowMotion * fall, 1.5, 1e-12);
    }
}

TEST(FrameTiming, KnowsUnitsAndTheUpAxis)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.object.unitsPerMetre = 1000;
    EXPECT_NEAR(fallTime(scene, meshOfHeight(1000)), std::sqrt(2 / 9.81), 1e-12);
    scene.object.up = Axis::x;
    EXPECT_NEAR(fallTime(scene, meshOfHeight(77)), std::sqrt(2 / 9810.0), 1e-12);
}

TEST(FrameTiming, TakesTheSlowMotionThatIsGiven)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.frames.slowMotion = 4;
    scene.frames.fps = 25;
    EXPECT_DOUBLE_EQ(frameTiming(scene, meshOfHeight(1)).interval, 0.01);
}

TEST(FrameEstimate, StaysWithinTheLimitAndIsNothingWithoutFrames)
{
    Scene scene = presetScene(Preset::paper, "torus");
    for (const std::size_t limit : {1u, 2u, 10u, 1000u})
    {
        scene.frames.limit = limit;
        EXPECT_LE(estimateFrames(scene, meshOfHeight(1), 1000000, 0.1).frames, limit);
        EXPECT_GE(estimateFrames(scene, meshOfHeight(1), 1000000, 0.1).frames, 1u);
    }
    scene.frames.limit = 0;
    EXPECT_GT(estimateFrames(scene, meshOfHeight(1), 1000000, 0.1).frames, 10000u);
    scene.frames.enabled = false;
    EXPECT_EQ(estimateFrames(scene, meshOfHeight(1), 1000, 0.1).frames, 0u);
}

} // namespace
} // namespace frostfill
