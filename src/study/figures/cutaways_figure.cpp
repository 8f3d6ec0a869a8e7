// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/panels.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr int kCutawaysSide = 210; // pixels; cutaways.gp has both
constexpr int kCutawaysStrip = 26;

Scene sceneOf(const std::string& object, bool quick)
{
    Scene scene = presetScene(Preset::fast, object);
    scene.spheres.count = quick ? 60 : 1500;
    makePanel(scene, kCutawaysSide);
    // The quarter that is nearest to the camera.
    scene.style.cutaway.kind = Cutaway::Kind::wedge;
    constexpr double kAzimuth = 30;
    scene.camera.azimuth = kAzimuth;
    scene.style.cutaway.from = kAzimuth - 45;
    scene.style.cutaway.to = kAzimuth + 45;
    return scene;
}

void makeCutawaysData(const FigureFolder& folder)
{
    Table table;
    table.headings = {"object", "column", "spheres", "frozen", "discarded", "polygons_discarded"};
    std::vector<Image> byState;
    std::vector<Image> bySet;
    for (const std::string object : {"torus", "sphere", "cube", "human"})
    {
        Scene scene = sceneOf(object, folder.quick());
        const TriangleMesh mesh = builtInMesh(object);
        const std::vector<FigureState> end = {endOf(scene, mesh)};
        const Snapshot& state = end.front().snapshot;
        table.rows.push_back({object, fmt::format("{}", byState.size()),
                              fmt::format("{}", state.states.size()),
                              fmt::format("{}", state.frozen), fmt::format("{}", state.discarded),
                              fmt::format("{}", state.discardedPolygons)});
        byState.push_back(drawStates(scene, mesh, end).front());
        scene.style.colourBy = "set";
        bySet.push_back(drawStates(scene, mesh, end).front());
    }
    byState.insert(byState.end(), bySet.begin(), bySet.end());
    folder.write("cutaways.csv", table);
    folder.write("cutaways-panels.png", joinPanels(byState, bySet.size(), kCutawaysStrip));
}

} // namespace

Figure cutawaysFigure()
{
    return {"cutaways",       "the four objects cut open", false, 3,
            makeCutawaysData, embedded::figure_cutaways};
}

} // namespace frostfill
