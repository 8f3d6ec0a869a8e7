// SPDX-License-Identifier: MIT
#include "simulation/freezing/room_maker.hpp"

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
TEST(RoomMaker, GivesTheNumberOfASphereThatIsWithdrawnToTheLastOne)
{
    const auto world = smallWorld(twoChambers());
    Threads threads(1);
    RestFollowers followers(*world, world->height, threads);
    Runners runners(world->resting.frame());
    const std::array<Vector3d, 3> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}, {5, 0, 0}};
    for (const Vector3d& place : places)
    {
        runners.add(world->release(place, 1, 0), place, 1);
    }
    runners.startFreezing();

    RoomMaker room(*world, runners, followers);
    ASSERT_FALSE(room.makeRoom(1, {places[1], 1}, kFarRoom));
    world->freeze(runners[1].id);
    room.evict();
    world->forgetFrozen();

    EXPECT_EQ(world->spheres.size(), 2u);
    EXPECT_EQ(runners[0].id, Runner::kNobody);
    EXPECT_TRUE(runners.isAsleep(0));
    EXPECT_EQ(runners[1].id, 1u);
    EXPECT_EQ(runners[2].id, 0u);
    EXPECT_EQ(world->spheres.position(0), places[2]);
    EXPECT_EQ(world->spheres.state[0], SphereState::running);
    EXPECT_EQ(world->runningIds, std::vector<std::uint32_t>{0});
}

TEST(RoomMaker, LetsASphereThatHasToLeaveAppearWhereThereIsRoom)
{
    const auto world = smallWorld(twoChambers());
    Threads threads(1);
    RestFollowers followers(*world, world->height, threads);
    Runners runners(world->resting.frame());
    const std::array<Vector3d, 2> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}};
    for (const Vector3d& place : places)
    {
        runners.add(world->release(place, 1, 0), place, 1);
    }
    runners.startFreezing();

    RoomMaker room(*world, runners, followers);
    ASSERT_FALSE(room.makeRoom(1, {places[1], 1}, kFarRoom));
    EXPECT_EQ(runners[0].position, places[0]) << "none is moved";
    world->freeze(runners[1].id);
    room.evict();

    EXPECT_EQ(world->spheres.size(), 2u);
    EXPECT_EQ(runners[0].id, 0u);
    EXPECT_LE((runners[0].position - Vector3d(5, 0, 0)).cwiseAbs().maxCoeff(), 0.2);
}

} // namespace
} // namespace frostfill
