// SPDX-License-Identifier: MIT
// What a tape shows is what the simulation showed, state by state. The oracle is the simulation.
#include "run_file/state_tape.hpp"

#include "run/frame_recorder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

using test::expectSame;

/// A run as its simulation showed it at every `every`-th state, and all of it on a tape.
struct SeenAndTaped
{
    std::vector<Snapshot> seen;
    std::vector<std::uint64_t> revisions;
    std::vector<SphereRecord> spheres; ///< in the end
    StateTape tape;
};

SeenAndTaped seeAndTape(const Scene& scene, std::size_t every)
{
    Simulation simulation(scene, loadMesh(scene.object.mesh).mesh);
    SeenAndTaped run{{}, {}, {}, {carriedColumns(), simulation.smallestRadius()}};
    Snapshot snapshot;
    snapshot.columns = carriedColumns();
    std::size_t states = 0;
    do
    {
        run.tape.add(LiveStates(simulation));
        if (states++ % every == 0)
        {
            simulation.capture(snapshot);
            roundPlaces(snapshot, simulation.smallestRadius(),
                        [&](std::uint32_t id) { return simulation.sphere(id); });
            run.seen.push_back(snapshot);
            run.revisions.push_back(simulation.revision());
        }
    } while (simulation.step());
    run.tape.add(LiveStates(simulation)); // what the end has discarded
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        run.spheres.push_back(simulation.sphere(id));
    }
    return run;
}

void expectTapeShows(const Scene& scene, std::size_t every)
{
    SeenAndTaped run = seeAndTape(scene, every);
    ASSERT_GT(run.seen.size(), 5u);
    TapeReader reader(std::move(run.tape));
    std::array<Snapshot, 3> snapshots; // filled in turn, as by the recorder of pictures
    for (Snapshot& each : snapshots)
    {
        each.columns = carriedColumns();
    }
    std::size_t taken = 0;
    std::size_t states = 0;
    for (; reader.next(); ++states)
    {
        if (states % every != 0 || taken == run.seen.size())
        {
            continue;
        }
        Snapshot& snapshot = snapshots[taken % 3];
        const Snapshot before = snapshot;
        reader.capture(snapshot);
        expectSame(snapshot, run.seen[taken]);
        EXPECT_EQ(reader.revision(), run.revisions[taken]);
        EXPECT_EQ(reader.time(), run.seen[taken].time);
        EXPECT_EQ(reader.sphereCount(), run.seen[taken].centres.size());
        EXPECT_TRUE(std::is_sorted(snapshot.changed.begin(), snapshot.changed.end()));
        for (std::uint32_t id = 0; id < snapshot.centres.size(); ++id)
        {
            const bool differs = id >= before.centres.size() ||
                                 before.centres[id] != snapshot.centres[id] ||
                                 before.states[id] != snapshot.states[id];
            EXPECT_TRUE(!differs ||
                        std::binary_search(snapshot.changed.begin(), snapshot.changed.end(), id));
        }
        ++taken;
    }
    EXPECT_EQ(taken, run.seen.size());
    ASSERT_EQ(reader.sphereCount(), run.spheres.size());
    for (std::size_t id = 0; id < run.spheres.size(); ++id)
    {
        const SphereRecord& sphere = run.spheres[id];
        ASSERT_NE(sphere.state, SphereState::running);
        EXPECT_EQ(reader.sphere(id).centre, sphere.centre);
        EXPECT_EQ(reader.sphere(id).radius, sphere.radius);
        EXPECT_EQ(reader.sphere(id).state, sphere.state);
        EXPECT_EQ(reader.sphere(id).group, sphere.group);
    }
}

Scene taped(const char* mesh, Motion motion, std::size_t count)
{
    Scene scene = presetScene(Preset::fast, mesh);
    scene.motion.mode = motion;
    scene.spheres.count = count;
    return scene;
}

TEST(StateTape, ShowsFallsAsTheyWereSimulated)
{
    expectTapeShows(taped("torus", Motion::fall, 80), 1);
}

TEST(StateTape, ShowsEverySeventhStateWithAllThatChangedBetween)
{
    expectTapeShows(taped("cube", Motion::skip, 150), 7);
}

TEST(StateTape, ShowsDifferentRadiiInAnObjectThatTilts)
{
    Scene scene = taped("cube", Motion::skip, 40);
    scene.spheres.radius = Radii(0.1, 0.2);
    scene.move.tilt = 20;
    expectTapeShows(scene, 2);
}

TEST(StateTape, IsGivenUpOnceItIsFull)
{
    const Scene scene = taped("torus", Motion::skip, 80);
    Simulation simulation(scene, loadMesh("torus").mesh);
    constexpr std::size_t kMost = 4000;
    StateTape tape({}, simulation.smallestRadius(), kMost);
    tape.add(LiveStates(simulation));
    EXPECT_FALSE(tape.isFull());
    while (simulation.step())
    {
        tape.add(LiveStates(simulation));
    }
    EXPECT_TRUE(tape.isFull());
    EXPECT_LT(tape.bytes(), 2 * kMost);
}

TEST(StateTape, ThatIsEmptyShowsNothing)
{
    TapeReader reader(StateTape({}, 0.1));
    EXPECT_FALSE(reader.next());
    EXPECT_FALSE(reader.next());
}

} // namespace
} // namespace frostfill
