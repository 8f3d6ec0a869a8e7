// SPDX-License-Identifier: MIT
#include <frostfill/simulation.hpp>

int main()
{
    frostfill::Scene scene = frostfill::presetScene(frostfill::Preset::paper, "cube");
    scene.spheres.count = 21;
    frostfill::Simulation simulation(scene, frostfill::loadMesh("cube").mesh);
    while (simulation.step())
    {
    }
    return simulation.sphereCount() == 21 ? 0 : 1;
}
