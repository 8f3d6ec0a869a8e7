// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <string>
#include <utility>

/// A small object whose spheres rest together in the end.
namespace frostfill
{

inline Scene jointScene(Motion motion, double friction)
{
    Scene scene = presetScene(Preset::fast, "box");
    scene.spheres.radius = 0.2;
    scene.spheres.count.reset();
    scene.motion.mode = motion;
    scene.rest.mode = Rest::joint;
    scene.rest.friction = friction;
    scene.judge.friction = friction;
    return scene;
}

inline TriangleMesh smallBox()
{
    return shapes::box({-1, -1, -1}, {1, 0.5, 1});
}

inline void run(Simulation& simulation)
{
    while (simulation.step())
    {
    }
}

/// Whatever changes no bit changes none; and discards are made in the end.
inline void expectSameBits(Motion motion)
{
    std::string hash;
    for (const auto& [threads, rule] : {std::pair(1, DiscardRule::exact),
                                        {2, DiscardRule::exact},
                                        {5, DiscardRule::exact},
                                        {2, DiscardRule::none}})
    {
        Scene scene = jointScene(motion, 0.3);
        scene.threads = threads;
        scene.discard.rule = rule;
        Simulation simulation(scene, smallBox());
        run(simulation);
        hash = hash.empty() ? simulation.stateHash() : hash;
        EXPECT_EQ(simulation.stateHash(), hash) << threads;
        Snapshot snapshot;
        simulation.capture(snapshot);
        EXPECT_EQ(snapshot.running, 0U);
        EXPECT_EQ(snapshot.discarded > 0, rule == DiscardRule::exact);
    }
}

} // namespace frostfill
