// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

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

} // namespace frostfill
