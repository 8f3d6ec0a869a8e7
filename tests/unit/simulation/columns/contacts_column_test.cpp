// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/columns/captured_column.hpp"
#include "unit/simulation/columns/contacts_oracle.hpp"
#include "unit/simulation/engine/small_torus.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// Does one thing to a world of spheres on a grid of places 2 apart, by chance.
void doSomething(World& world, std::uint64_t k)
{
    const auto draw = [&](std::uint64_t n) { return uniformRandom(7, k, n); };
    const auto count = static_cast<double>(world.spheres.size());
    const auto id = static_cast<std::uint32_t>(count * draw(0));
    if (count < 60 || draw(1) < 0.2)
    {
        const auto cell = [&](std::uint64_t n) { return std::floor(4 * draw(n)) - 2; };
        world.spheres.add(2 * Vector3d(cell(2), cell(3), cell(4)), 1, 0);
    }
    else if (world.spheres.isRunning(id))
    {
        if (draw(5) < 0.3)
        {
            world.spheres.withdraw(id);
        }
        else
        {
            const auto moved = Vector3d(draw(6) < 0.1 ? 0.5 : 0, 0, 0);
            world.spheres.freeze(id, world.spheres.position(id) + moved);
        }
        world.spheres.closeRanks();
    }
    else if (draw(5) < 0.5)
    {
        world.spheres.wake(id);
    }
    else if (world.spheres.state(id) == SphereState::frozen)
    {
        world.spheres.discard(id);
    }
}

TEST(ContactsColumn, FollowsWhateverHappens)
{
    const auto world = smallWorld(room());
    test::CapturedColumn column(*world, "contacts");
    std::vector<double> before;
    std::size_t most = 0;
    for (std::uint64_t k = 0; k < 3000; ++k)
    {
        doSomething(*world, k);
        if (uniformRandom(8, k, 0) < 0.6)
        {
            continue; // several things between two looks
        }
        const std::vector<std::uint32_t>& told = column.capture();
        before.resize(world->spheres.size());
        for (std::uint32_t id = 0; id < world->spheres.size(); ++id)
        {
            const double now = column[id];
            const test::CountedContacts expected = test::countContacts(*world, id);
            ASSERT_EQ(now, expected.spheres + expected.walls) << id << " after " << k;
            ASSERT_EQ(std::binary_search(told.begin(), told.end(), id), before[id] != now) << id;
            before[id] = now;
            most = std::max<std::size_t>(most, expected.spheres);
        }
    }
    EXPECT_GE(most, 6u);
}

TEST(ContactsColumn, ForgetsWhatTheNumberOfARunningSphereHadAtRest)
{
    const auto world = smallWorld(room());
    test::CapturedColumn column(*world, "contacts");
    const std::uint32_t runs = world->spheres.add({5, 5, 5}, 1, 0);
    addResting(*world, {0, 0, 0});
    const std::uint32_t last = addResting(*world, {2, 0, 0});
    column.capture();
    EXPECT_EQ(column[last], 1);
    world->spheres.withdraw(runs); // its number goes to the last one
    world->spheres.closeRanks();
    ASSERT_EQ(world->spheres.add({5, 5, 5}, 1, 0), last);
    column.capture();
    EXPECT_EQ(column[last], 0);
    EXPECT_EQ(column[runs], 1);
}

TEST(ContactsColumn, LooksAgainBesideASphereThatWokeAndWasWithdrawn)
{
    const auto world = smallWorld(room());
    test::CapturedColumn column(*world, "contacts");
    const std::uint32_t stays = addResting(*world, {0, 0, 0});
    const std::uint32_t goes = addResting(*world, {2, 0, 0});
    column.capture();
    EXPECT_EQ(column[stays], 1);
    world->spheres.wake(goes);
    world->spheres.withdraw(goes);
    world->spheres.closeRanks();
    column.capture();
    EXPECT_EQ(column[stays], 0);
}

/// A snapshot that asks for all columns.
Snapshot asking()
{
    Snapshot snapshot;
    snapshot.columns = carriedColumns();
    return snapshot;
}

/// Every value of the columns, and that no sphere whose value differs from before is left out of
/// what changed.
void expectSame(const Snapshot& kept, const Snapshot& before, const Snapshot& fresh)
{
    ASSERT_EQ(kept.columns.size(), fresh.columns.size());
    for (std::size_t k = 0; k < kept.columns.size(); ++k)
    {
        ASSERT_EQ(kept.columns[k].bits, fresh.columns[k].bits);
        for (std::uint32_t id = 0; id < kept.states.size(); ++id)
        {
            const bool listed = std::binary_search(kept.changed.begin(), kept.changed.end(), id);
            ASSERT_TRUE(listed || kept.columns[k].at(id) == before.columns[k].at(id)) << id;
        }
    }
}

// Two snapshots take turns, so that each misses what the other has seen.
TEST(Capture, BringsColumnsUpToDateAndListsWhatChanged)
{
    const Column& contacts = *findColumn("contacts");
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 0.13;
    scene.spheres.count = 80;
    scene.move.tilt = 40; // what rests wakes again
    Simulation simulation(scene, shapes::torus());
    std::array<Snapshot, 2> kept = {asking(), asking()};
    double sum = 0;
    bool more = true;
    for (std::size_t turn = 0; more; ++turn)
    {
        for (int k = 0; k < 11 && more; ++k)
        {
            more = simulation.step();
        }
        Snapshot& snapshot = kept[turn % 2];
        const Snapshot before = snapshot;
        simulation.capture(snapshot);
        Snapshot fresh = asking();
        simulation.capture(fresh);
        ASSERT_NO_FATAL_FAILURE(expectSame(snapshot, before, fresh));
        sum = 0;
        for (std::uint32_t id = 0; id < snapshot.states.size(); ++id)
        {
            const double value = snapshot.values(contacts)->at(id);
            ASSERT_TRUE(snapshot.states[id] != SphereState::running || value == 0);
            sum += value;
        }
    }
    const std::vector<ColumnValues> atEnd = simulation.columns();
    simulation.capture(kept[0]);
    ASSERT_EQ(findValues(atEnd, contacts)->bits, kept[0].values(contacts)->bits);
    // A sphere that is carried by less than three others hangs in the air, walls aside.
    EXPECT_GT(sum / static_cast<double>(kept[0].states.size()), 3);
    EXPECT_LT(sum / static_cast<double>(kept[0].states.size()), 12);
}

TEST(Capture, CarriesNoColumnThatNobodyAskedFor)
{
    Simulation simulation(test::smallTorus(), shapes::torus());
    Snapshot snapshot;
    simulation.step();
    simulation.capture(snapshot);
    EXPECT_TRUE(snapshot.columns.empty());
}

// Nothing changes any more when it is asked for, so that no list of changes brings the values.
TEST(Capture, FillsAColumnThatIsAskedForLate)
{
    Simulation simulation(test::smallTorus(), shapes::torus());
    Snapshot snapshot;
    while (simulation.step())
    {
        simulation.capture(snapshot);
    }
    simulation.capture(snapshot);
    snapshot.columns = carriedColumns();
    simulation.capture(snapshot);
    const std::vector<ColumnValues> expected = simulation.columns();
    const Column& contacts = *findColumn("contacts");
    for (std::uint32_t id = 0; id < snapshot.states.size(); ++id)
    {
        EXPECT_GT(snapshot.values(contacts)->at(id), 0) << id;
    }
    EXPECT_EQ(snapshot.values(contacts)->bits, findValues(expected, contacts)->bits);
}

} // namespace
} // namespace frostfill
