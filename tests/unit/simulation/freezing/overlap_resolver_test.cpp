// SPDX-License-Identifier: MIT
#include "simulation/freezing/overlap_resolver.hpp"

#include "base/random.hpp"
#include "simulation/freezing/tolerances.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <array>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// Two chambers, each of which has room for one sphere.
TriangleMesh twoChambers()
{
    TriangleMesh mesh = shapes::box({-6.2, -1.2, -1.2}, {-3.8, 1.2, 1.2}, 2);
    const TriangleMesh other = shapes::box({3.8, -1.2, -1.2}, {6.2, 1.2, 1.2}, 2);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
    {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return mesh;
}

// In one chamber the second sphere comes to rest on the first, which can go nowhere, as the third
// runs in the other chamber.
TEST(OverlapResolver, GivesTheNumberOfASphereThatIsWithdrawnToTheLastOne)
{
    const auto world = smallWorld(twoChambers());
    Threads threads(1);
    RestObservers observers(*world, world->height, threads);
    RunnerGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {});
    RunningSpheres& running = world->spheres.running();
    const std::array<Vector3d, 3> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}, {5, 0, 0}};
    for (const Vector3d& place : places)
    {
        world->spheres.add(place, 1, 0);
    }
    grid.rebuild(running);

    OverlapResolver room(*world, grid, flight, observers);
    ASSERT_FALSE(room.moveAside(1, {places[1], 1}, kFarRoom));
    world->spheres.freeze(1);
    room.evict();

    EXPECT_EQ(world->spheres.size(), 2u);
    EXPECT_TRUE(running.isGone(0));
    EXPECT_TRUE(running.isGone(1));
    EXPECT_EQ(running.id[2], 0u);
    EXPECT_EQ(world->spheres.state(1), SphereState::frozen);
    EXPECT_EQ(world->spheres.position(0), places[2]);
    EXPECT_EQ(world->spheres.state(0), SphereState::running);
    world->spheres.closeRanks();
    ASSERT_EQ(running.size(), 1u);
    EXPECT_EQ(running.id[0], 0u);
}

TEST(OverlapResolver, LetsASphereThatHasToLeaveAppearWhereThereIsRoom)
{
    const auto world = smallWorld(twoChambers());
    Threads threads(1);
    RestObservers observers(*world, world->height, threads);
    RunnerGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {});
    RunningSpheres& running = world->spheres.running();
    const std::array<Vector3d, 2> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}};
    for (const Vector3d& place : places)
    {
        world->spheres.add(place, 1, 0);
    }
    grid.rebuild(running);

    OverlapResolver room(*world, grid, flight, observers);
    ASSERT_FALSE(room.moveAside(1, {places[1], 1}, kFarRoom));
    EXPECT_EQ(running.position[0], places[0]) << "none is moved";
    world->spheres.freeze(1);
    room.evict();

    EXPECT_EQ(world->spheres.size(), 2u);
    EXPECT_EQ(running.id[0], 0u);
    EXPECT_LE((running.position[0] - Vector3d(5, 0, 0)).cwiseAbs().maxCoeff(), 0.2);
}

/// A crowd in a box that comes to rest one after another, some of it on the floor already.
class Crowded
{
public:
    explicit Crowded(std::uint64_t seed)
        : world_(smallWorld(shapes::box({-6, -6, -6}, {6, 6, 6}, 3))), seed_(seed)
    {
        for (std::uint64_t k = 0; k < 8; ++k)
        {
            addResting(*world_, at(k));
        }
        for (std::uint64_t k = 8; k < 24; ++k)
        {
            world_->spheres.add(at(k), 1, 0);
        }
        grid_.rebuild(running_);
        room_.makeReady(running_.size());
        for (std::uint32_t row = 0; row < running_.size(); ++row)
        {
            rest_.push_back({running_.position[row] - Vector3d(0, 0.1, 0), 1});
        }
    }

    void lookAhead()
    {
        for (std::uint32_t row = 0; row < running_.size(); ++row)
        {
            room_.lookForOverlapped(row, rest_[row]);
            room_.lookForRoom(row, rest_[row], farthest(row));
        }
    }
    /// Returns what is to be seen of it.
    std::vector<double> freeze(std::uint32_t row)
    {
        const bool found = room_.moveAside(row, rest_[row], farthest(row));
        if (found || row % 5 == 0)
        {
            world_->spheres.freeze(running_.id[row], rest_[row].place);
            if (!found)
            {
                room_.evict();
            }
        }
        std::vector<double> seen = {found ? 1.0 : 0.0};
        seen.insert(seen.end(), room_.overlapped().begin(), room_.overlapped().end());
        for (const Vector3d& place : running_.position.all())
        {
            seen.insert(seen.end(), place.begin(), place.end());
        }
        return seen;
    }
    [[nodiscard]] const RunningSpheres& running() const { return running_; }

private:
    /// Nearly all overlap somebody.
    [[nodiscard]] Vector3d at(std::uint64_t k) const
    {
        const auto along = [&](std::uint64_t axis)
        { return 7 * uniformRandom(seed_, k, axis) - 3.5; };
        return {along(0), along(1), along(2)};
    }
    [[nodiscard]] static double farthest(std::uint32_t row)
    {
        return row % 2 == 0 ? kFarRoom : kNearRoom;
    }

    std::unique_ptr<World> world_;
    std::uint64_t seed_;
    Threads threads_{1};
    RestObservers observers_{*world_, world_->height, threads_};
    RunnerGrid grid_{world_->spheres.resting().frame()};
    FreeFlight flight_{*world_, {}};
    RunningSpheres& running_ = world_->spheres.running();
    OverlapResolver room_{*world_, grid_, flight_, observers_};
    std::vector<PlacedSphere> rest_; // by row
};

// Others are moved aside, come to rest, or appear elsewhere, in between.
TEST(OverlapResolver, MovesAsideWhatItWouldWithoutHavingLookedAhead)
{
    int found = 0;
    int inTheWay = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        Crowded with(seed);
        Crowded without(seed);
        with.lookAhead();
        for (std::uint32_t row = 0; row < with.running().size(); ++row)
        {
            if (with.running().isGone(row))
            {
                continue;
            }
            const std::vector<double> seen = with.freeze(row);
            ASSERT_EQ(seen, without.freeze(row)) << "row " << row << " of seed " << seed;
            found += seen.front() > 0 ? 1 : 0;
            inTheWay += seen.size() > 1 + 3 * std::size_t{with.running().size()} ? 1 : 0;
        }
    }
    EXPECT_GT(found, 500);
    EXPECT_GT(inTheWay, 500);
}

} // namespace
} // namespace frostfill
