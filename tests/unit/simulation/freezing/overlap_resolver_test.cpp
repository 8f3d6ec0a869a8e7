// SPDX-License-Identifier: MIT
#include "simulation/freezing/overlap_resolver.hpp"

#include "simulation/contact/depenetration.hpp"
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
    const auto release = makeRelease(*world, world->height, threads);
    SphereGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {});
    RunningSpheres& running = world->spheres.running();
    const std::array<Vector3d, 3> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}, {5, 0, 0}};
    for (const Vector3d& place : places)
    {
        world->spheres.add(place, 1, 0);
    }
    gather(grid, running);

    OverlapResolver room(*world, grid, flight, release);
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
    const auto release = makeRelease(*world, world->height, threads);
    SphereGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {});
    RunningSpheres& running = world->spheres.running();
    const std::array<Vector3d, 2> places = {Vector3d(-5, 0.1, 0), {-5, -0.1, 0}};
    for (const Vector3d& place : places)
    {
        world->spheres.add(place, 1, 0);
    }
    gather(grid, running);

    OverlapResolver room(*world, grid, flight, release);
    ASSERT_FALSE(room.moveAside(1, {places[1], 1}, kFarRoom));
    EXPECT_EQ(running.position[0], places[0]) << "none is moved";
    world->spheres.freeze(1);
    room.evict();

    EXPECT_EQ(world->spheres.size(), 2u);
    EXPECT_EQ(running.id[0], 0u);
    EXPECT_LE((running.position[0] - Vector3d(5, 0, 0)).cwiseAbs().maxCoeff(), 0.2);
}

} // namespace
} // namespace frostfill
