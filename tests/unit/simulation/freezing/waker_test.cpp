// SPDX-License-Identifier: MIT
#include "simulation/freezing/waker.hpp"

#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Steps to the end; returns whether it came within so many steps.
bool comesToRest(Simulation& simulation, std::uint64_t most)
{
    while (simulation.steps() < most)
    {
        if (!simulation.step())
        {
            return true;
        }
    }
    return false;
}

Scene smallScene(const std::string& object, std::size_t count, std::uint64_t seed)
{
    Scene scene = presetScene(Preset::fast, object);
    scene.spheres.count = count;
    scene.spheres.groupSize = 30;
    scene.spheres.groupsPerSet = 1;
    scene.seed = seed;
    scene.threads = 1;
    return scene;
}

// What a pile froze on woke at once, because freezing let a gap of 0.005 r carry and waking only
// one of a millionth: these runs had no end.
TEST(Waker, WhatAPileFrozeOnStaysAtRestInAMovedObject)
{
    Scene turned = smallScene("torus", 23, 582664);
    turned.motion.restitution = 0.8;
    turned.move.turn = 180;
    Simulation simulation(turned, builtInMesh("torus"));
    ASSERT_TRUE(comesToRest(simulation, 20000));
    EXPECT_EQ(simulation.restingCount(), simulation.sphereCount());
    EXPECT_EQ(simulation.quality().unsupported, 0u);
}

TEST(Waker, MovedObjectsComeToRest)
{
    for (const char* object : {"torus", "sphere", "cube", "human"})
    {
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
        {
            Scene scene = smallScene(object, 60, seed);
            scene.move.tilt = 30.0 * static_cast<double>(seed);
            scene.move.turn = seed == 2 ? 180 : 0;
            scene.move.shake = seed == 3 ? 0.02 : 0;
            Simulation simulation(scene, builtInMesh(object));
            EXPECT_TRUE(comesToRest(simulation, 40000)) << object << ", seed " << seed;
            EXPECT_EQ(simulation.quality().centresOutside, 0u);
        }
    }
}

// On its head, a column holds itself up but for its last sphere: each goes once the next has gone.
TEST(Waker, LetsGoWhatRestedOnWhatItLetsGo)
{
    Scene scene = smallScene("cube", 10, 1);
    scene.spheres.radius = 1;
    scene.move.tilt = 180;
    World world(scene, shapes::box({-8, -8, -8}, {8, 8, 8}, 8));
    for (int k = 0; k < 6; ++k)
    {
        addResting(world, {0, -7.0 + 2 * k, 0});
    }
    const std::uint32_t underTheLid = addResting(world, {5, 7, 5});
    Waker waker(world);
    ASSERT_TRUE(waker.begin());
    world.pull.uniform = {0, 1, 0};
    EXPECT_TRUE(waker.wakeWhenDue());
    EXPECT_EQ(world.spheres.running().size(), 6u);
    EXPECT_EQ(world.spheres.state(underTheLid), SphereState::frozen);
}

TEST(Waker, LeavesNothingAtRestThatTheJudgeFindsUncarried)
{
    for (const double tilt : {10.0, 20.0, 60.0, 120.0, 180.0})
    {
        Scene scene = smallScene("cube", 150, 4);
        scene.spheres.radius = 0.12;
        scene.discard.rule = DiscardRule::none;
        World world(scene, builtInMesh("cube"));
        const auto engine = makeEngine(world);
        while (engine->step())
        {
        }
        scene.move.tilt = tilt;
        world.motion = ObjectMotion(scene.move, world.frame, world.height);
        Waker waker(world);
        ASSERT_TRUE(waker.begin());
        world.pull = world.motion.pullAt(2 * world.motion.duration());
        EXPECT_GT(examine(world).unsupported, 0u) << tilt;
        EXPECT_TRUE(waker.wakeWhenDue());
        EXPECT_GT(world.spheres.running().size(), 0u) << tilt;
        EXPECT_EQ(examine(world).unsupported, 0u) << tilt;
    }
}

} // namespace
} // namespace frostfill
