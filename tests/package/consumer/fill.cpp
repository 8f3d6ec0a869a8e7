// SPDX-License-Identifier: MIT
#include <frostfill/fill.hpp>

int main()
{
    using namespace frostfill;
    FillRequest request;
    request.scene = presetScene(Preset::fast, "torus");
    request.directory = "torus";
    request.scene.spheres.radius = 0.1;
    request.scene.spheres.count = 20;
    request.scene.frames.selection = "last";
    const FillResult result = fill(request);
    return !result.failure && result.spheres == 20 ? 0 : 1;
}
