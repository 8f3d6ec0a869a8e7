// SPDX-License-Identifier: MIT
// Spheres that come through openings only.
#include "simulation/release/inlets.hpp"

#include "simulation/release/tolerances.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;
using test::expectError;

/// The cube, from -1 to 1 in all directions, with these inlets.
Scene sceneWith(std::vector<Inlet> inlets)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 0.1;
    scene.spheres.count.reset();
    scene.spheres.inlets = std::move(inlets);
    return scene;
}

ReleaseQuery anyPlace()
{
    return {.suits = [](const Vector3d&, double) { return true; }};
}

TEST(Inlets, LetSpheresInWhollyWithinTheOpeningsAndEvenly)
{
    // One has twice the room of the other for centres, so four times the area; one stands upright.
    const World world(sceneWith({{{-0.4, 0.5, 0.1}, 0.3}, {{0.5, 0.2, -0.3}, 0.2}}),
                      builtInMesh("cube"));
    Inlets inlets(world);
    std::array<int, 2> count = {};
    int inner = 0;
    constexpr int kDraws = 4000;
    for (int k = 0; k < kDraws; ++k)
    {
        const auto sphere = inlets.next(anyPlace());
        ASSERT_TRUE(sphere);
        EXPECT_EQ(sphere->radius, 1);
        const Vector3d p = world.frame.toMesh(sphere->place);
        const bool second = p.y() < 0.4;
        const Inlet& inlet = world.scene.spheres.inlets[second ? 1 : 0];
        EXPECT_NEAR(p.y(), inlet.centre.y(), 1e-12);
        const double arm = std::hypot(p.x() - inlet.centre.x(), p.z() - inlet.centre.z());
        EXPECT_LE(arm, inlet.radius - 0.1 + 1e-12);
        inner += !second && arm < 0.1 ? 1 : 0;
        ++count[second ? 1 : 0];
    }
    // Shares go by the areas of the openings.
    EXPECT_NEAR(count[0], kDraws * 9 / 13.0, 120);
    EXPECT_NEAR(inner, count[0] / 4.0, 120);
}

TEST(Inlets, AreLevelWhicheverAxisPointsUp)
{
    Scene scene = sceneWith({{{0.1, 0.2, 0.5}, 0.3}});
    scene.object.up = Axis::z;
    const World world(scene, builtInMesh("cube"));
    Inlets inlets(world);
    for (int k = 0; k < 20; ++k)
    {
        EXPECT_NEAR(world.frame.toMesh(inlets.next(anyPlace())->place).z(), 0.5, 1e-12);
    }
}

TEST(Inlets, LetNothingInWhileSomethingRestsInThem)
{
    World world(sceneWith({{{0, 0.5, 0}, 0.15}}), builtInMesh("cube"));
    Inlets inlets(world);
    EXPECT_TRUE(inlets.any());
    world.spheres.addResting(world.frame.toRun({0, 0.5, 0}), 1, 0);
    EXPECT_FALSE(inlets.any());
    EXPECT_FALSE(inlets.next(anyPlace()));
    EXPECT_FALSE(inlets.findsEveryPlace());
}

TEST(Inlets, KeepTheRadiusForWhichThereWasNoPlaceYet)
{
    Scene scene = sceneWith({{{0, 0.5, 0}, 0.3}});
    scene.spheres.radius = Radii(0.05, 0.1);
    const World world(scene, builtInMesh("cube"));
    Inlets waits(world);
    Inlets goes(world);
    EXPECT_FALSE(waits.next({.suits = [](const Vector3d&, double) { return false; }}));
    for (int k = 0; k < 5; ++k)
    {
        EXPECT_EQ(waits.next(anyPlace())->radius, goes.next(anyPlace())->radius);
    }
}

TEST(Inlets, AreRefusedOutsideAndWhereNoSphereComesThrough)
{
    const TriangleMesh cube = builtInMesh("cube");
    expectError(
        ErrorCode::usage,
        [&] {
            const Simulation none(sceneWith({{{0, 1.2, 0}, 0.3}}), cube);
        },
        "(0 1.2 0)", "not inside the object");
    expectError(
        ErrorCode::usage,
        [&] {
            const Simulation none(sceneWith({{{0, 0, 0}, 0.09}}), cube);
        },
        "radius 0.09", "narrower than the largest sphere");
    expectError(
        ErrorCode::usage,
        [&] {
            const Simulation none(sceneWith({{{0, 0.95, 0}, 0.3}}), cube);
        },
        "(0 0.95 0)", "no room for a sphere");
    // The smaller ones would come through, the larger never.
    Scene unlike = sceneWith({{{0, 0.93, 0}, 0.3}});
    unlike.spheres.radius = Radii(0.05, 0.1);
    expectError(
        ErrorCode::usage, [&] { const Simulation none(unlike, cube); }, "no room for a sphere");
}

TEST(Inlets, EndARunWhenTheHeapReachesThem)
{
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = sceneWith({{{0, 0.4, 0}, 0.15}});
        scene.motion.mode = motion;
        Simulation simulation(scene, builtInMesh("cube"));
        test::runToEnd(simulation);
        EXPECT_TRUE(simulation.inletsReached());
        EXPECT_FALSE(simulation.full());
        double highest = -1;
        for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
        {
            const Vector3d p = simulation.sphere(id).centre;
            highest = std::max(highest, p.y());
        }
        EXPECT_GT(highest, 0.1) << "in the way of whatever comes";
        EXPECT_LT(highest, 0.4 + 0.1 * kOffInInlet + 1e-6);
        const QualityReport quality = simulation.quality();
        EXPECT_EQ(quality.unsupported, 0U);
        EXPECT_EQ(quality.centresOutside, 0U);
        EXPECT_TRUE(std::isnan(quality.volumeEstimate)) << "much of the cube is empty";
        EXPECT_GT(simulation.sphereCount(), 60U);
        EXPECT_LT(simulation.sphereCount(), 1000U);
    }
}

TEST(Inlets, LeadToTheSameStateWithAndWithoutDiscardsAndThreads)
{
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        const auto hashOf = [&](DiscardRule rule, int threads)
        {
            Scene scene = sceneWith({{{0.2, 0.4, 0}, 0.2}, {{-0.5, 0.6, 0.3}, 0.15}});
            scene.motion.mode = motion;
            scene.discard.rule = rule;
            scene.threads = threads;
            Simulation simulation(scene, builtInMesh("cube"));
            test::runToEnd(simulation);
            return simulation.stateHash();
        };
        const std::string hash = hashOf(DiscardRule::exact, 1);
        EXPECT_EQ(hashOf(DiscardRule::none, 1), hash);
        EXPECT_EQ(hashOf(DiscardRule::exact, 2), hash);
    }
}

TEST(Inlets, ServeThePresetPaperToo)
{
    Scene scene = presetScene(Preset::paper, "cube");
    scene.spheres.radius = 0.15;
    scene.spheres.count = 12;
    scene.spheres.groupSize = 2;
    scene.spheres.inlets = {{{0, 0.6, 0}, 0.2}};
    Simulation simulation(scene, builtInMesh("cube"));
    std::size_t seen = 0;
    while (simulation.step())
    {
        for (; seen < simulation.sphereCount(); ++seen)
        {
            const Vector3d p = simulation.sphere(seen).centre;
            EXPECT_LE(std::hypot(p.x(), p.z()), 0.06) << seen;
        }
    }
    EXPECT_EQ(seen, 12U);
}

} // namespace
} // namespace frostfill
