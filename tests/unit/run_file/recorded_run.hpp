// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

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

inline void expectSame(const Snapshot& read, const Snapshot& written)
{
    EXPECT_EQ(read.centres, written.centres);
    EXPECT_EQ(read.radii, written.radii);
    EXPECT_EQ(read.states, written.states);
    EXPECT_EQ(read.groups, written.groups);
    EXPECT_EQ(read.speeds, written.speeds);
    EXPECT_EQ(read.polygons, written.polygons);
    EXPECT_EQ(read.origin, written.origin);
    EXPECT_EQ(read.pose.rotation, written.pose.rotation);
    EXPECT_EQ(read.pose.offset, written.pose.offset);
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.step, written.step);
    EXPECT_EQ(read.set, written.set);
    EXPECT_EQ(read.running, written.running);
    EXPECT_EQ(read.frozen, written.frozen);
    EXPECT_EQ(read.discarded, written.discarded);
    EXPECT_EQ(read.discardedPolygons, written.discardedPolygons);
    ASSERT_EQ(read.columns.size(), written.columns.size());
    for (std::size_t k = 0; k < read.columns.size(); ++k)
    {
        EXPECT_EQ(read.columns[k].bits, written.columns[k].bits);
    }
}

} // namespace frostfill::test
