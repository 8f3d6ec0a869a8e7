// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/fps/paper_numbers.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr double kClosenesses[] = {0.3, 0.6, 1, 1.5, 2, 3}; // [r]; the first is the default

std::vector<std::string> rowOf(const std::string& object, double closeness, bool quick)
{
    Scene scene = presetScene(Preset::paper, object);
    scene.search = {SphereSearch::grid, PolygonSearch::grid}; // the same bits as the loops, sooner
    scene.discard.closeness = closeness;
    if (quick)
    {
        scene.spheres.count = 60;
    }
    const TriangleMesh mesh = builtInMesh(object);
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    Snapshot end;
    simulation.capture(end);
    const QualityReport quality = simulation.quality();
    const double share =
        static_cast<double>(end.discardedPolygons) / static_cast<double>(mesh.triangles.size());
    return {object,
            fmt::format("{:g}", closeness),
            fmt::format("{}", simulation.sphereCount()),
            fmt::format("{:.1f}", 100 * share),
            fmt::format("{:g}", paperNumbers(object)->polygonsDiscarded),
            fmt::format("{}", quality.centresOutside),
            fmt::format("{:.2f}", quality.maxOverlap),
            fmt::format("{:.2f}", quality.maxWallOverlap),
            fmt::format("{}", quality.unsupported)};
}

void makeClosenessData(const FigureFolder& folder)
{
    Table table;
    table.headings = {"object",  "closeness",   "spheres",     "polygons_percent", "paper_percent",
                      "outside", "max_overlap", "max_in_wall", "unsupported"};
    const std::vector<std::string> objects = builtInMeshNames();
    for (const std::string& object : objects)
    {
        for (const double closeness : kClosenesses)
        {
            folder.progress()(table.rows.size(), objects.size() * std::size(kClosenesses),
                              fmt::format("{}, {:g} r", object, closeness));
            table.rows.push_back(rowOf(object, closeness, folder.quick()));
        }
    }
    folder.write("closeness.csv", table);
}

} // namespace

Figure closenessFigure()
{
    return {"closeness",
            "PAPER, 51 %: what covers a polygon against what is discarded and what escapes",
            false,
            4,
            makeClosenessData,
            embedded::figure_closeness};
}

} // namespace frostfill
