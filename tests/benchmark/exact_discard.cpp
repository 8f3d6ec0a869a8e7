// SPDX-License-Identifier: MIT
// Exact discards on against off: whether the results are equal bit for bit, how much is dropped,
// and what it costs, on every object and with many seeds. Prints CSV; exits with 2 when a pair of
// runs differs. Run it by hand:
// build/release/tests/benchmark/benchmark_exact_discard [SPHERES [SEEDS [FOLDER [OBJECT]]]]
// where FOLDER has the real meshes

#include "support/discard_objects.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <numeric>
#include <string>

namespace frostfill
{
namespace
{

struct Result
{
    std::string hash;
    double spheres = 0;
    double droppedSpheres = 0;  ///< share of the spheres, at the end
    double meanDropped = 0;     ///< the same, mean over the sets
    double droppedPolygons = 0; ///< share of the polygons, at the end
    double discarding = 0;      ///< share of the time of all stages
    double processor = 0;       ///< [s] of the whole run
};

Result run(Scene scene, const TriangleMesh& mesh, DiscardRule rule, int threads)
{
    scene.discard.rule = rule;
    scene.threads = threads;
    const std::clock_t start = std::clock();
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    Result result;
    result.processor = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    result.hash = simulation.stateHash();
    result.spheres = static_cast<double>(simulation.sphereCount());
    const auto& sets = simulation.sets();
    result.droppedSpheres = static_cast<double>(sets.back().discarded) / result.spheres;
    for (const SetRecord& set : sets)
    {
        const auto resting = static_cast<double>(set.frozen + set.discarded);
        result.meanDropped += resting > 0 ? static_cast<double>(set.discarded) / resting : 0;
    }
    result.meanDropped /= static_cast<double>(sets.size());
    result.droppedPolygons = static_cast<double>(sets.back().discardedPolygons) /
                             static_cast<double>(mesh.triangles.size());
    const StageTimes& times = simulation.times();
    result.discarding = times[Stage::discarding] /
                        std::accumulate(times.seconds.begin(), times.seconds.end(), 1e-12);
    return result;
}

/// Of one object with all seeds. Returns whether all pairs of runs were equal.
bool compare(const std::string& name, const TriangleMesh& mesh, Motion motion, bool untilFull,
             std::uint64_t spheres, std::uint64_t seeds)
{
    Result mean;
    double without = 0;
    std::uint64_t equal = 0;
    std::uint64_t equalThreads = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
        Scene scene = presetScene(Preset::fast, name);
        scene.seed = seed;
        scene.motion.mode = motion;
        scene.spheres.radius.reset();
        scene.spheres.count = spheres;
        scene.spheres.untilFull = untilFull;
        const Result on = run(scene, mesh, DiscardRule::exact, 1);
        const Result off = run(scene, mesh, DiscardRule::none, 1);
        equal += on.hash == off.hash ? 1 : 0;
        const bool sameThreads = run(scene, mesh, DiscardRule::exact, 2).hash == on.hash &&
                                 run(scene, mesh, DiscardRule::exact, 8).hash == on.hash;
        equalThreads += sameThreads ? 1 : 0;
        const auto share = 1 / static_cast<double>(seeds);
        mean.spheres += share * on.spheres;
        mean.droppedSpheres += share * on.droppedSpheres;
        mean.meanDropped += share * on.meanDropped;
        mean.droppedPolygons += share * on.droppedPolygons;
        mean.discarding += share * on.discarding;
        mean.processor += share * on.processor;
        without += share * off.processor;
    }
    fmt::print("{},{},{},{},{},{},{},{:.0f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", name,
               mesh.triangles.size(), motion == Motion::fall ? "fall" : "skip",
               untilFull ? "full" : "count", seeds, equal, equalThreads, mean.spheres,
               mean.droppedSpheres, mean.meanDropped, mean.droppedPolygons, mean.discarding,
               mean.processor, without);
    std::fflush(stdout);
    return equal == seeds && equalThreads == seeds;
}

int compareAll(std::uint64_t spheres, std::uint64_t seeds, const std::string& folder,
               const std::string& only)
{
    fmt::print("object,polygons,motion,until,seeds,equal_on_off,equal_threads,spheres,"
               "spheres_dropped,spheres_dropped_mean,polygons_dropped,discard_share_of_time,"
               "seconds_on,seconds_off\n");
    bool allEqual = true;
    for (const std::string& name : discardObjectNames())
    {
        if (!only.empty() && name != only)
        {
            continue;
        }
        const auto mesh = discardObject(name, folder);
        if (!mesh)
        {
            fmt::print(stderr, "{} is skipped: {} is not there\n", name,
                       discardObjectFile(name, folder).string());
            continue;
        }
        for (const Motion motion : {Motion::fall, Motion::skip})
        {
            for (const bool untilFull : {false, true})
            {
                allEqual = compare(name, *mesh, motion, untilFull, spheres, seeds) && allEqual;
            }
        }
    }
    return allEqual ? 0 : 2;
}

} // namespace
} // namespace frostfill

int main(int count, char** arguments)
{
    const auto number = [&](int index, std::uint64_t otherwise)
    { return count > index ? std::strtoull(arguments[index], nullptr, 10) : otherwise; };
    return frostfill::compareAll(number(1, 500), number(2, 1), count > 3 ? arguments[3] : "",
                                 count > 4 ? arguments[4] : "");
}
