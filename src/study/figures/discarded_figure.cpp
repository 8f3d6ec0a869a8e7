// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kDiscardedSpheres = 2000;
constexpr std::uint64_t kQuickDiscardedSpheres = 60;

Scene sceneOf(const std::string& object, Preset preset, std::uint64_t spheres)
{
    Scene scene = presetScene(preset, object);
    scene.spheres.count = spheres;
    scene.spheres.groupSize = 10;
    scene.spheres.groupsPerSet = 2;
    if (preset == Preset::paper)
    {
        scene.search = {SphereSearch::grid, PolygonSearch::grid};
    }
    return scene;
}

void addRun(Table& table, const std::string& object, Preset preset, std::uint64_t spheres)
{
    const TriangleMesh mesh = builtInMesh(object);
    Simulation simulation(sceneOf(object, preset, spheres), mesh);
    while (simulation.step())
    {
    }
    std::size_t present = 0;
    const auto percent = [](std::size_t part, std::size_t whole) {
        return fmt::format("{:.3f}",
                           100.0 * static_cast<double>(part) / static_cast<double>(whole));
    };
    for (const SetRecord& set : simulation.sets())
    {
        present += set.spheres;
        table.rows.push_back({object, preset == Preset::paper ? "paper" : "exact",
                              percent(present, simulation.sphereCount()),
                              fmt::format("{}", present), percent(set.discarded, present),
                              percent(set.discardedPolygons, mesh.triangles.size())});
    }
}

void makeDiscardedData(const FigureFolder& folder)
{
    Table table;
    table.headings = {"object",
                      "rule",
                      "present_percent",
                      "spheres",
                      "discarded_spheres_percent",
                      "discarded_polygons_percent"};
    for (const std::string object : {"torus", "sphere", "cube", "human"})
    {
        for (const Preset preset : {Preset::paper, Preset::fast})
        {
            addRun(table, object, preset,
                   folder.quick() ? kQuickDiscardedSpheres : kDiscardedSpheres);
        }
    }
    folder.write("discarded.csv", table);
}

} // namespace

Figure discardedFigure()
{
    return {"discarded",
            "share of discarded spheres and polygons over the run",
            false,
            4,
            makeDiscardedData,
            embedded::figure_discarded};
}

} // namespace frostfill
