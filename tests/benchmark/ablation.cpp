// SPDX-License-Identifier: MIT
// What each skip of the fast engine is worth: each one switched off in turn, with its price in time
// and what it does to the result. Prints CSV; every row is the run with the least processor time of
// three. Run it by hand on an idle machine:
// build/release/tests/benchmark/benchmark_ablation [SPHERES] > ablation.csv

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

struct Variant
{
    const char* name;
    std::function<void(Scene&)> change;
};

const std::vector<Variant>& variants()
{
    static const std::vector<Variant> all = {
        {"reference", [](Scene&) {}},
        {"no discard", [](Scene& scene) { scene.discard.rule = DiscardRule::none; }},
        {"no neighbour lists", [](Scene& scene) { scene.search.neighbourLists = false; }},
        {"free flight simulated", [](Scene& scene) { scene.motion.mode = Motion::fall; }},
        {"no dynamics", [](Scene& scene) { scene.motion.mode = Motion::descend; }},
        {"half the time step", [](Scene& scene) { scene.motion.dt = *scene.motion.dt / 2; }},
        {"sets freeze whole", [](Scene& scene) { scene.freezing.rule = FreezingRule::bySet; }},
        {"one sweep", [](Scene& scene) { scene.motion.sweeps = 1; }},
        {"sets of 200",
         [](Scene& scene)
         {
             scene.spheres.groupSize = 100;
             scene.spheres.groupsPerSet = 2;
         }},
    };
    return all;
}

void printRow(const std::string& object, const Variant& variant, const TriangleMesh& mesh,
              std::uint64_t spheres, double& reference)
{
    Scene scene = presetScene(Preset::fast, object);
    scene.spheres.count = spheres;
    scene.motion.mode = Motion::skip;
    scene.discard.rule = DiscardRule::exact;
    scene.threads = 1;
    scene.motion.dt = Simulation(scene, mesh).timeStep();
    variant.change(scene);
    double least = 1e300;
    std::string row;
    for (int repeat = 0; repeat < 3; ++repeat)
    {
        const std::clock_t start = std::clock();
        Simulation simulation(scene, mesh);
        while (simulation.step())
        {
        }
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (seconds >= least)
        {
            continue;
        }
        least = seconds;
        const QualityReport quality = simulation.quality();
        const SetRecord& last = simulation.sets().back();
        const auto count = static_cast<double>(simulation.sphereCount());
        row = fmt::format("{},{:.3g},{:.3g},{:.5f},{:.4f},{:.4f},{:.4f},{}", simulation.steps(),
                          quality.maxOverlap, quality.maxWallOverlap,
                          static_cast<double>(quality.unsupported) / count,
                          quality.sphereVolume / quality.meshVolume,
                          static_cast<double>(last.discarded) / count,
                          static_cast<double>(last.discardedPolygons) /
                              static_cast<double>(mesh.triangles.size()),
                          simulation.stateHash());
    }
    reference = reference > 0 ? reference : least;
    fmt::print("{},{},{},{:.4f},{:.3f},{}\n", object, spheres, variant.name, least,
               least / reference, row);
    std::fflush(stdout);
}

} // namespace
} // namespace frostfill

int main(int count, char** arguments)
{
    using namespace frostfill;
    const std::uint64_t spheres = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 2000;
    fmt::print("object,spheres,variant,processor_seconds,times_reference,steps,max_overlap,"
               "max_wall_overlap,unsupported,packing_fraction,spheres_dropped,polygons_dropped,"
               "state_hash\n");
    for (const char* object : {"torus", "cube", "human"})
    {
        const TriangleMesh mesh = builtInMesh(object);
        double reference = 0;
        for (const Variant& variant : variants())
        {
            printRow(object, variant, mesh, spheres, reference);
        }
    }
}
