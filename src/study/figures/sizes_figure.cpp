// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <filesystem>

namespace frostfill
{
namespace
{

constexpr double kRatio = 10; ///< of the largest to the smallest
constexpr const char* kKinds[] = {"count", "full_within", "full"};

/// Shares of the mass, evenly over the radii.
std::string evenByMass(double largest)
{
    return fmt::format("radius,cumulative mass\n{},0\n{},1\n", largest / kRatio, largest);
}

Scene sceneOf(const std::string& kind, const std::filesystem::path& curve, std::uint64_t count)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.motion.mode = Motion::descend;
    scene.spheres.count.reset();
    scene.spheres.sizes.curve = curve.string();
    if (kind == "count")
    {
        scene.spheres.count = count;
    }
    if (kind == "full")
    {
        scene.spheres.sizes.within.reset();
    }
    return scene;
}

void makeSizesData(const FigureFolder& folder)
{
    // The program reads it as anybody's.
    folder.write("sizes-asked.csv", evenByMass(folder.quick() ? 0.5 : 0.15));
    const std::filesystem::path curve = folder.path("sizes-asked.csv");
    const TriangleMesh mesh = builtInMesh("cube");
    Table table;
    table.headings = {"run", "radius", "asked_percent", "achieved_percent", "spheres"};
    for (std::size_t k = 0; k < std::size(kKinds); ++k)
    {
        folder.progress()(k, std::size(kKinds), kKinds[k]);
        Simulation simulation(sceneOf(kKinds[k], curve, folder.quick() ? 100 : 15000), mesh);
        while (simulation.step())
        {
        }
        const std::optional<SizeReport> sizes = simulation.sizes();
        for (const SizePoint& point : sizes->points)
        {
            table.rows.push_back({kKinds[k], fmt::format("{:.6g}", point.radius),
                                  fmt::format("{:.5f}", 100 * point.asked),
                                  fmt::format("{:.5f}", 100 * point.achieved),
                                  fmt::format("{}", simulation.sphereCount())});
        }
    }
    folder.write("sizes.csv", table);
}

} // namespace

Figure sizesFigure()
{
    return {"sizes",       "size curves by mass, as asked and as achieved",
            false,         20,
            makeSizesData, embedded::figure_sizes};
}

} // namespace frostfill
