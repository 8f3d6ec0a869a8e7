// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/panels.hpp"

#include <array>

namespace frostfill
{
namespace
{

/// A picture as `frostfill fill torus` draws it, a little past the middle of the run.
void makeTorusData(const FigureFolder& folder)
{
    Scene scene = presetScene(Preset::fast, "torus");
    const std::array<std::size_t, 1> spheres = {folder.quick() ? 40UL : 200UL};
    const TriangleMesh mesh = builtInMesh("torus");
    folder.write("torus.png", drawStates(scene, mesh, statesOf(scene, mesh, spheres)).front());
}

/// The same with smaller spheres in the style for covers.
void makeStudio(const FigureFolder& folder)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = folder.quick() ? 60UL : 1500UL;
    scene.spheres.radius.reset();
    scene.spheres.groupSize = 40;
    scene.style.look = Look::studio;
    scene.style.palette = paletteOf(Look::studio);
    const std::array<std::size_t, 1> spheres = {*scene.spheres.count * 5 / 8};
    const TriangleMesh mesh = builtInMesh("torus");
    folder.write("studio.png", drawStates(scene, mesh, statesOf(scene, mesh, spheres)).front());
}

} // namespace

Figure studioFigure()
{
    return {"studio", "the torus while it fills, in the style studio", false, 1, makeStudio,
            nullptr};
}

Figure torusFigure()
{
    return {"torus", "the torus while it fills, as a run draws it", false, 1, makeTorusData,
            nullptr};
}

} // namespace frostfill
