// SPDX-License-Identifier: MIT
// What each part of the paper's method is worth, measured in one run: milliseconds a step of the
// torus, and ratios. Run it by hand on an idle machine:
// build/release/tests/benchmark/benchmark_paper

#include <frostfill/mesh.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

struct Variant
{
    const char* name;
    PolygonSearch polygons;
    std::uint32_t freezeEvery;
    DiscardRule discard;
};

struct Timing
{
    double lastSetMs = 0;  ///< a step of the last set
    double wholeRunMs = 0; ///< a step over the whole run
    double seconds = 0;
};

double stepSeconds(const StageTimes& times)
{
    return times[Stage::sphereSphere] + times[Stage::spherePolygon] + times[Stage::motion] +
           times[Stage::freezing] + times[Stage::discarding];
}

Timing timeRun(const Variant& variant, const TriangleMesh& mesh)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.search.polygons = variant.polygons;
    scene.freezing.everySets = variant.freezeEvery;
    scene.discard.rule = variant.discard;
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    const SetRecord& last = simulation.sets().back();
    const double all = stepSeconds(simulation.times());
    return {1e3 * stepSeconds(last.times) / static_cast<double>(last.steps),
            1e3 * all / static_cast<double>(simulation.steps()), all};
}

/// The median of three, by the last set.
Timing medianRun(const Variant& variant, const TriangleMesh& mesh)
{
    std::vector<Timing> runs;
    for (int repeat = 0; repeat < 3; ++repeat)
    {
        runs.push_back(timeRun(variant, mesh));
    }
    std::sort(runs.begin(), runs.end(),
              [](const Timing& a, const Timing& b) { return a.lastSetMs < b.lastSetMs; });
    return runs[1];
}

void compareVariants()
{
    const std::vector<Variant> variants = {
        {"loop, freeze each set", PolygonSearch::loop, 1, DiscardRule::none},
        {"loop, never freeze", PolygonSearch::loop, 0, DiscardRule::none},
        {"list, freeze each set", PolygonSearch::list, 1, DiscardRule::none},
        {"tree, freeze each set", PolygonSearch::quadtree, 1, DiscardRule::none},
        {"tree, discards", PolygonSearch::quadtree, 1, DiscardRule::paper},
        {"tree, discards, freeze every 2", PolygonSearch::quadtree, 2, DiscardRule::paper},
    };
    const TriangleMesh mesh = builtInMesh("torus");
    fmt::print("torus, 320 spheres, sets of 20; ratios to the first row\n");
    fmt::print("{:32} {:>14} {:>8} {:>14} {:>8} {:>10} {:>8}\n", "", "last set ms", "ratio",
               "whole run ms", "ratio", "seconds", "ratio");
    Timing first;
    for (const Variant& variant : variants)
    {
        const Timing timing = medianRun(variant, mesh);
        first = &variant == &variants.front() ? timing : first;
        fmt::print("{:32} {:14.4f} {:8.2f} {:14.4f} {:8.2f} {:10.3f} {:8.2f}\n", variant.name,
                   timing.lastSetMs, first.lastSetMs / timing.lastSetMs, timing.wholeRunMs,
                   first.wholeRunMs / timing.wholeRunMs, timing.seconds,
                   first.seconds / timing.seconds);
    }
}

} // namespace
} // namespace frostfill

int main()
{
    frostfill::compareVariants();
}
