// SPDX-License-Identifier: MIT
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

} // namespace
} // namespace frostfill
