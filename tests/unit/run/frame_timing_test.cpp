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

TEST(FrameTiming, ARunTakesTwentySecondsOfVideoWhateverItsSizeAndLength)
{
    for (const double height : {0.15, 2.8, 500.0})
    {
        const Scene scene = presetScene(Preset::paper, "torus");
        const double fall = fallTime(scene, meshOfHeight(height));
        const FrameTiming timing = frameTiming(scene, meshOfHeight(height), 10 * fall);
        EXPECT_NEAR(10 * fall / timing.interval, 20 * 30 - 1, 1e-9);
        EXPECT_NEAR(timing.slowMotion * 10 * fall, 20 - 1 / 30.0, 1e-12);
    }
}

TEST(FrameTiming, AFewSpheresDoNotCreepUnlessAskedTo)
{
    Scene scene = presetScene(Preset::fast, "torus");
    const double fall = fallTime(scene, meshOfHeight(1));
    EXPECT_NEAR(frameTiming(scene, meshOfHeight(1), 2 * fall).slowMotion * fall, 3, 1e-12);
    scene.frames.duration = 20;
    EXPECT_NEAR(frameTiming(scene, meshOfHeight(1), 2 * fall).slowMotion * fall, 10, 0.1);
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
    EXPECT_DOUBLE_EQ(frameTiming(scene, meshOfHeight(1), 9).interval, 0.01);
}

TEST(FramePlan, StaysWithinTheLimitAndIsNothingWithoutFrames)
{
    Scene scene = presetScene(Preset::paper, "torus");
    const RunLength length = {1000, true};
    for (const std::size_t limit : {1u, 2u, 10u, 40u, 599u, 600u, 1000u})
    {
        scene.frames.limit = limit;
        const FramePlan plan = planFrames(scene, meshOfHeight(1), length);
        EXPECT_LE(plan.kept, limit);
        EXPECT_GE(2 * plan.kept, std::min<std::size_t>(limit, 600)) << limit;
        EXPECT_NEAR(plan.timing.slowMotion, 0.02, 0.001) << "the limit changes no speed";
    }
    scene.frames.limit = 0;
    scene.frames.slowMotion = 1;
    EXPECT_GT(planFrames(scene, meshOfHeight(1), length).kept, 29000u);
    scene.frames.enabled = false;
    EXPECT_EQ(planFrames(scene, meshOfHeight(1), length).kept, 0u);
}

} // namespace
} // namespace frostfill
