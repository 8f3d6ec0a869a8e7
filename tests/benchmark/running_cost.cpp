// SPDX-License-Identifier: MIT
// What a substep of one running sphere costs the fast engine, as more and more spheres are at rest:
// the cube is filled with a million of them, and every row is a stretch of that one run. A second
// table times the paper's own scene. Run it by hand on an idle machine:
// build/release/tests/benchmark/benchmark_running_cost [RADIUS]

#include <frostfill/mesh.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace frostfill
{
namespace
{

constexpr double kRadius = 0.0101; // a million fill the cube
constexpr double kRowEvery = 2;    // times as many at rest as in the row before

double movingSeconds(const StageTimes& times)
{
    return times[Stage::motion] + times[Stage::sphereSphere];
}

double stepSeconds(const StageTimes& times)
{
    return movingSeconds(times) + times[Stage::freezing] + times[Stage::discarding] +
           times[Stage::releasing];
}

/// What happened since the last row.
struct Stretch
{
    double moving = 0; ///< [s] when it began
    double all = 0;    ///< [s] when it began
    double sphereSteps = 0;
    std::size_t atRest = 0; ///< when it began
};

void growth(double radius)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = radius;
    scene.spheres.count.reset();
    scene.spheres.untilFull = true;
    scene.motion.mode = Motion::skip;
    scene.threads = 1;
    Simulation simulation(scene, builtInMesh("cube"));
    fmt::print("cube, radius {:g}, until full, --motion skip, one thread\n"
               "{:>12} {:>14} {:>24} {:>24}\n",
               radius, "at rest", "sphere steps", "us a sphere's step", "the same with freezing,");
    fmt::print("{:>12} {:>14} {:>24} {:>24}\n", "", "", "(flight, encounters)",
               "discards and releases");
    double nextRow = 1e4;
    Stretch stretch;
    bool going = true;
    while (going)
    {
        going = simulation.step();
        stretch.sphereSteps +=
            static_cast<double>(simulation.sphereCount() - simulation.restingCount());
        if (static_cast<double>(simulation.restingCount()) < nextRow && going)
        {
            continue;
        }
        const double moving = movingSeconds(simulation.times());
        const double all = stepSeconds(simulation.times());
        fmt::print("{:>12} {:>14.0f} {:>24.3f} {:>24.3f}\n",
                   fmt::format("{}", simulation.restingCount()), stretch.sphereSteps,
                   1e6 * (moving - stretch.moving) / stretch.sphereSteps,
                   1e6 * (all - stretch.all) / stretch.sphereSteps);
        std::fflush(stdout);
        stretch = {moving, all, 0, simulation.restingCount()};
        nextRow *= kRowEvery;
    }
}

/// A step of the paper's torus from 280 spheres at rest on, the fastest of many runs.
struct TorusStep
{
    double moving = 1e300; ///< [s] flight and encounters
    double all = 1e300;    ///< [s] with freezing, discards and releases
    double running = 0;    ///< spheres, on the mean
};

/// 20 spheres appear at a time, 320 in all, over 1,152 polygons.
TorusStep timeTorus(const TriangleMesh& mesh)
{
    constexpr int kRuns = 20;
    TorusStep best;
    for (int repeat = 0; repeat < kRuns; ++repeat)
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.count = 320;
        scene.spheres.groupSize = 10;
        scene.spheres.groupsPerSet = 2;
        scene.threads = 1;
        Simulation simulation(scene, mesh);
        while (simulation.restingCount() < 280 && simulation.step())
        {
        }
        const StageTimes before = simulation.times();
        const std::uint64_t steps = simulation.steps();
        double spheres = 0;
        while (simulation.step())
        {
            spheres += static_cast<double>(simulation.sphereCount() - simulation.restingCount());
        }
        const auto taken = static_cast<double>(simulation.steps() - steps);
        const StageTimes& after = simulation.times();
        best.moving = std::min(best.moving, (movingSeconds(after) - movingSeconds(before)) / taken);
        best.all = std::min(best.all, (stepSeconds(after) - stepSeconds(before)) / taken);
        best.running = spheres / taken;
    }
    return best;
}

void paperScene()
{
    const TriangleMesh mesh = builtInMesh("torus");
    const TorusStep step = timeTorus(mesh);
    fmt::print(
        "\ntorus, {} polygons, 280 to 320 spheres at rest, {:.1f} running on the mean: {:.4f} "
        "ms a step, {:.4f} ms with freezing, discards and releases\n",
        mesh.triangles.size(), step.running, 1e3 * step.moving, 1e3 * step.all);
}

} // namespace
} // namespace frostfill

int main(int count, char** arguments)
{
    frostfill::growth(count > 1 ? std::strtod(arguments[1], nullptr) : frostfill::kRadius);
    frostfill::paperScene();
}
