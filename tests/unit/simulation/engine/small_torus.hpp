// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

namespace frostfill::test
{

inline Scene smallTorus()
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres.radius = 0.13;
    scene.spheres.count = 80;
    scene.search.polygons = PolygonSearch::loop;
    return scene;
}

inline void runToEnd(Simulation& simulation)
{
    while (simulation.step())
    {
    }
}

} // namespace frostfill::test
