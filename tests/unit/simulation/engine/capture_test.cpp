// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

using test::runToEnd;
using test::smallTorus;

TEST(Capture, IncrementalEqualsFresh)
{
    Simulation simulation(smallTorus(), shapes::torus());
    Snapshot kept;
    std::uint64_t steps = 0;
    bool more = true;
    while (more)
    {
        more = simulation.step();
        if (more && ++steps % 7 != 0)
        {
            continue;
        }
        simulation.capture(kept);
        Snapshot fresh;
        simulation.capture(fresh);
        ASSERT_EQ(kept.centres, fresh.centres);
        ASSERT_EQ(kept.states, fresh.states);
        ASSERT_EQ(kept.radii, fresh.radii);
        ASSERT_EQ(kept.groups, fresh.groups);
        ASSERT_EQ(kept.polygons, fresh.polygons);
        ASSERT_EQ(kept.running, fresh.running);
    }
}

// What ran or runs, what changed its state and what is new: these and no others, in ascending
// order.
TEST(Capture, ListsWhatChangedAndNothingElse)
{
    Scene scene = smallTorus();
    scene.freezing.everySets = 1;
    Simulation simulation(scene, shapes::torus());
    Snapshot snapshot;
    std::size_t frozenSeen = 0;
    bool more = true;
    while (more)
    {
        for (int k = 0; k < 7 && more; ++k)
        {
            more = simulation.step();
        }
        const Snapshot before = snapshot;
        simulation.capture(snapshot);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t id = 0; id < snapshot.centres.size(); ++id)
        {
            const bool isNew = id >= before.centres.size();
            const bool runs = snapshot.states[id] == SphereState::running;
            if (isNew || runs || snapshot.states[id] != before.states[id])
            {
                expected.push_back(id);
            }
            else
            {
                ASSERT_EQ(snapshot.centres[id], before.centres[id]);
                ++frozenSeen;
            }
        }
        ASSERT_EQ(snapshot.changed, expected) << "step " << simulation.steps();
    }
    EXPECT_EQ(snapshot.centres.size(), 80u);
    EXPECT_GT(frozenSeen, 1000u);
    // The run is over and everything at rest: the next capture lists nothing.
    simulation.capture(snapshot);
    EXPECT_TRUE(snapshot.changed.empty()) << snapshot.changed.size();
}

// Explicit Euler, in mesh units of which a metre has eight: after N steps g N dt.
TEST(Capture, TellsTheSpeedOfWhatFallsAndZeroForWhatIsAtRest)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres = {0.05, 1, false, 1, 1};
    scene.object.unitsPerMetre = 8;
    Simulation simulation(scene, shapes::box({-1, -10, -1}, {1, 0, 1}));
    Snapshot snapshot;
    for (int step = 1; step <= 50; ++step)
    {
        simulation.step();
        simulation.capture(snapshot);
        const double expected = 9.81 * 8 * step * simulation.timeStep();
        ASSERT_NEAR(snapshot.speeds[0], expected, 1e-5 * expected) << "step " << step;
    }
    runToEnd(simulation);
    simulation.capture(snapshot);
    EXPECT_EQ(snapshot.speeds[0], 0);
}

} // namespace
} // namespace frostfill
