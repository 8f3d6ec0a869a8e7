// SPDX-License-Identifier: MIT
#include "base/statistics.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

struct Part
{
    const char* name;
    Preset preset;
    Motion motion;
};
constexpr Part kParts[] = {{"paper", Preset::paper, Motion::fall},
                           {"fast", Preset::fast, Motion::fall},
                           {"skip", Preset::fast, Motion::skip}};
constexpr std::uint32_t kSetSizes[] = {1, 2, 5, 10, 20, 50, 100};

double packing(const Part& part, std::uint32_t setSize, std::uint64_t seed, std::uint64_t spheres,
               const TriangleMesh& mesh, const MeshReport& report)
{
    Scene scene = presetScene(part.preset, "cube");
    scene.spheres.count = spheres;
    scene.spheres.radius = Radii(sphereRadius(scene, report));
    scene.spheres.count.reset();
    scene.spheres.groupSize = setSize;
    scene.spheres.groupsPerSet = 1;
    scene.freezing.everySets = 1;
    scene.motion.mode = part.motion;
    scene.seed = seed;
    if (part.preset == Preset::paper)
    {
        scene.discard.rule = DiscardRule::none;
        scene.search = {SphereSearch::grid, PolygonSearch::grid};
    }
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    const QualityReport quality = simulation.quality();
    return 100 * quality.sphereVolume / quality.meshVolume;
}

void makeDensityData(const FigureFolder& folder)
{
    const TriangleMesh mesh = builtInMesh("cube");
    const MeshReport report = inspectMesh(mesh);
    const std::uint64_t spheres = folder.quick() ? 30 : 1000;
    const std::uint64_t seeds = folder.quick() ? 2 : 5;
    Table table;
    table.headings = {"method", "set_size", "packing_percent", "half_width_95", "runs"};
    for (const Part& part : kParts)
    {
        for (const std::uint32_t setSize : kSetSizes)
        {
            folder.progress()(table.rows.size(), std::size(kParts) * std::size(kSetSizes),
                              fmt::format("{}, sets of {}", part.name, setSize));
            std::vector<double> runs;
            for (std::uint64_t seed = 1; seed <= seeds; ++seed)
            {
                runs.push_back(packing(part, setSize, seed, spheres, mesh, report));
            }
            const RepeatedMean found = meanOfRepeats(runs);
            table.rows.push_back(
                {part.name, fmt::format("{}", setSize), fmt::format("{:.4f}", found.mean),
                 fmt::format("{:.4f}", found.halfWidth), fmt::format("{}", runs.size())});
        }
    }
    folder.write("density.csv", table);
}

} // namespace

Figure densityFigure()
{
    return {"density",       "share of the volume that is filled, against the size of a set",
            false,           13,
            makeDensityData, embedded::figure_density};
}

} // namespace frostfill
