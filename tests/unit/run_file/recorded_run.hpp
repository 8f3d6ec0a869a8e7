// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>
#include <frostfill/simulation.hpp>

#include <filesystem>
#include <string_view>
#include <vector>

namespace frostfill::test
{

/// A run that was written to a file, with what the file has to say of each frame.
struct RecordedRun
{
    TriangleMesh mesh;
    std::vector<std::size_t> numbers;
    std::vector<Snapshot> frames;
    std::vector<SphereRecord> spheres; ///< in the end
};

/// Three snapshots are filled in turn, as by the recorder of pictures; `every` so many steps.
inline RecordedRun recordRun(const Scene& scene, const std::filesystem::path& file,
                             std::size_t every = 3, EarlierFile earlier = EarlierFile::replace,
                             std::string_view head = R"({"name": "test"})")
{
    RecordedRun run;
    run.mesh = loadMesh(scene.object.mesh).mesh;
    Simulation simulation(scene, run.mesh);
    RunFileWriter writer(file, head, run.mesh, simulation.smallestRadius(), earlier);
    std::array<Snapshot, 3> snapshots;
    for (Snapshot& snapshot : snapshots)
    {
        snapshot.columns = carriedColumns();
    }
    const auto take = [&]
    {
        const std::size_t number = 2 * run.numbers.size();
        Snapshot& snapshot = snapshots[run.numbers.size() % 3];
        simulation.capture(snapshot);
        const auto exact = [&](std::uint32_t id) { return simulation.sphere(id); };
        roundPlaces(snapshot, simulation.smallestRadius(), exact);
        writer.put(number, snapshot, exact);
        run.numbers.push_back(number);
        run.frames.push_back(snapshot);
    };
    take();
    for (std::size_t step = 1; simulation.step(); ++step)
    {
        if (step % every == 0)
        {
            take();
        }
    }
    take();
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        run.spheres.push_back(simulation.sphere(id));
    }
    writer.finish(R"({"outcome": "complete"})");
    return run;
}

} // namespace frostfill::test
