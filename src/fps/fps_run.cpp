// SPDX-License-Identifier: MIT
#include "fps/fps_run.hpp"

#include <frostfill/simulation.hpp>

#include <chrono>

namespace frostfill
{

FpsRun timeRun(const Scene& scene, const TriangleMesh& mesh)
{
    using Clock = std::chrono::steady_clock;
    Simulation simulation(scene, mesh);
    Snapshot snapshot;
    FpsRun run;
    StageTimes before;
    for (;;)
    {
        const auto start = Clock::now();
        if (!simulation.step())
        {
            break;
        }
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        const StageTimes& now = simulation.times();
        const auto spent = [&](Stage stage) { return 1000 * (now[stage] - before[stage]); };
        run.steps.push_back({static_cast<std::uint32_t>(simulation.sets().size() - 1),
                             spent(Stage::sphereSphere), spent(Stage::spherePolygon), ms});
        before = now;
        while (run.sets.size() < simulation.sets().size())
        {
            simulation.capture(snapshot);
            run.sets.push_back({snapshot.running, snapshot.frozen, snapshot.discarded,
                                snapshot.discardedPolygons});
        }
    }
    simulation.capture(snapshot);
    run.spheres = simulation.sphereCount();
    run.radius = simulation.radius();
    run.frozen = snapshot.frozen;
    run.discarded = snapshot.discarded;
    run.discardedPolygons = snapshot.discardedPolygons;
    run.stateHash = simulation.stateHash();
    return run;
}

} // namespace frostfill
