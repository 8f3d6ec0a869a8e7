// SPDX-License-Identifier: MIT
#include "lab/growth.hpp"

#include "simulation/paper/algorithm1.hpp"
#include "simulation/world/frame_of_run.hpp"

#include <frostfill/simulation.hpp>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <span>

namespace frostfill
{
namespace
{

/// Each step is repeated so often, on equal copies; the fastest counts.
constexpr int kRepeats = 3;

double totalMs(const StageTimes& times)
{
    return 1000 * std::accumulate(times.seconds.begin(), times.seconds.end(), 0.0);
}

GrowthPoint meanOf(std::span<const SetRecord> sets, std::size_t present)
{
    std::uint64_t steps = 0;
    std::size_t spheres = 0;
    double tests = 0;
    double ms = 0;
    for (const SetRecord& set : sets)
    {
        steps += set.steps;
        spheres += set.spheres;
        tests += static_cast<double>(set.operations.tests());
        ms += totalMs(set.times);
    }
    const auto count = static_cast<double>(std::max<std::uint64_t>(steps, 1));
    const auto appeared = static_cast<double>(std::max<std::size_t>(spheres, 1));
    return {present, tests / count, ms / count, tests / appeared, ms / appeared};
}

/// A step of Algorithm 1 with all spheres of a run, moving with no speed.
GrowthPoint oneStep(const Simulation& simulation, const FrameOfRun& frame, const Surface& surface,
                    PolygonSearchPart& polygons)
{
    GrowthPoint point;
    point.spheres = simulation.sphereCount();
    for (int repeat = 0; repeat < kRepeats; ++repeat)
    {
        Spheres spheres;
        for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
        {
            const SphereRecord sphere = simulation.sphere(id);
            spheres.add(frame.toRun(sphere.centre), sphere.radius / frame.length, sphere.group);
        }
        const std::span<const Eigen::Vector3d> places = spheres.running().position.all();
        const std::vector<Eigen::Vector3d> before(places.begin(), places.end());
        OperationCounts counts;
        Algorithm1 algorithm(spheres, surface, polygons, {});
        algorithm.clearTouched();
        const auto start = std::chrono::steady_clock::now();
        algorithm.runningRunning(counts);
        algorithm.runningPolygons(before, counts);
        const std::chrono::duration<double, std::milli> ms =
            std::chrono::steady_clock::now() - start;
        point.tests = static_cast<double>(counts.tests());
        point.ms = repeat == 0 ? ms.count() : std::min(point.ms, ms.count());
    }
    return point;
}

} // namespace

std::vector<GrowthPoint> growthOfRun(const Scene& scene, const TriangleMesh& mesh,
                                     std::size_t points)
{
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    // The last set has none after it: its frames are those of a run that comes to its end.
    const std::span<const SetRecord> all = simulation.sets();
    const auto sets = all.first(all.size() - std::min<std::size_t>(all.size(), 1));
    const std::size_t perPoint = (sets.size() + points - 1) / points;
    std::vector<GrowthPoint> result;
    std::size_t present = 0;
    for (std::size_t first = 0; first < sets.size(); first += perPoint)
    {
        const auto some = sets.subspan(first, std::min(perPoint, sets.size() - first));
        for (const SetRecord& set : some)
        {
            present += set.spheres;
        }
        result.push_back(meanOf(some, present));
    }
    return result;
}

std::vector<GrowthPoint> growthWithoutFreezing(const Scene& scene, const TriangleMesh& mesh,
                                               std::size_t points)
{
    Simulation simulation(scene, mesh);
    const FrameOfRun frame(scene, boundingBox(mesh), simulation.radius());
    const Surface surface(frame.toRun(mesh));
    const std::vector<PolygonState> active(mesh.triangles.size(), PolygonState::active);
    const auto polygons = makePolygonSearch(PolygonSearch::loop, {surface, active});
    const std::size_t apart = std::max<std::size_t>(simulation.expectedSpheres() / points, 1);
    std::vector<GrowthPoint> result;
    while (simulation.step())
    {
        if (simulation.sphereCount() >= (result.size() + 1) * apart)
        {
            result.push_back(oneStep(simulation, frame, surface, *polygons));
        }
    }
    return result;
}

} // namespace frostfill
