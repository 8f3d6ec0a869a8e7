// SPDX-License-Identifier: MIT
#include "lab/growth.hpp"
#include "lab/study.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::size_t kPoints = 50;
constexpr std::uint64_t kClaimSpheres = 10000;
constexpr std::uint64_t kQuickClaimSpheres = 400;

Scene torusScene(Preset preset, std::uint64_t spheres)
{
    Scene scene = presetScene(preset, "torus");
    scene.spheres.groupsPerSet = 2;
    scene.spheres.groupSize = static_cast<std::uint32_t>(spheres / 200);
    // One set more, which is not shown.
    scene.spheres.count = spheres + 2 * scene.spheres.groupSize;
    scene.freezing.everySets = 1;
    scene.discard.rule = DiscardRule::none;
    scene.search = {SphereSearch::allPairs, PolygonSearch::loop};
    scene.threads = 1; // as the paper's method, so that times can be compared
    return scene;
}

} // namespace

Table measureClaim(bool quick, const LabProgress& progress)
{
    const std::uint64_t spheres = quick ? kQuickClaimSpheres : kClaimSpheres;
    const TriangleMesh mesh = builtInMesh("torus");
    Scene freezing = torusScene(Preset::paper, spheres);
    Scene discards = freezing;
    discards.discard.rule = DiscardRule::paper;
    Scene grid = freezing;
    grid.search = {SphereSearch::grid, PolygonSearch::grid};
    const Scene fast = torusScene(Preset::fast, spheres);

    Table table;
    table.headings = {"method", "spheres", "tests", "ms", "sphere_tests", "sphere_ms"};
    const auto add = [&](const char* method, const std::vector<GrowthPoint>& measured)
    {
        for (const GrowthPoint& p : measured)
        {
            table.rows.push_back({method, fmt::format("{}", p.spheres),
                                  fmt::format("{:.6g}", p.tests), fmt::format("{:.6g}", p.ms),
                                  fmt::format("{:.6g}", p.testsOfSphere),
                                  fmt::format("{:.6g}", p.msOfSphere)});
        }
    };
    constexpr std::size_t kCurves = 5;
    std::size_t curves = 0;
    progress(curves++, kCurves, "all pairs without freezing");
    add("all running", growthWithoutFreezing(grid, mesh, kPoints / 2));
    for (const auto& [method, scene] :
         {std::pair{"freezing", freezing}, std::pair{"discards", discards}, std::pair{"grid", grid},
          std::pair{"fast", fast}})
    {
        progress(curves++, kCurves, method);
        add(method, growthOfRun(scene, mesh, kPoints));
    }
    return table;
}

} // namespace frostfill
