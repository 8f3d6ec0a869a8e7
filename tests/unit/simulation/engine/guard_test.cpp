// SPDX-License-Identifier: MIT
#include "simulation/engine/guard.hpp"

#include "simulation/motion/drop_and_roll.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

class GuardTest : public ::testing::Test
{
protected:
    std::unique_ptr<World> world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}));
    Guard guard{*world};

    /// What the guard finds after a step.
    std::optional<StraySphere> found()
    {
        guard.check();
        return world->clock.stray;
    }
};

TEST_F(GuardTest, LetsSpheresInsideRunAndRest)
{
    world->spheres.add({0, 0, 0}, 1, 0);
    world->spheres.running().velocity[0] = {0, -5, 0};
    world->spheres.add({-9.5, 0, 0}, 1, 0);
    addResting(*world, {4, -9, 4});
    EXPECT_FALSE(found());
    EXPECT_FALSE(world->clock.finished);
}

TEST_F(GuardTest, StopsTheRunForASphereThatHasLeftTheObject)
{
    world->spheres.add({0, 0, 0}, 1, 0);
    world->spheres.add({0, 14, 0}, 1, 0);
    world->clock.time = 2;
    const auto stray = found();
    ASSERT_TRUE(stray);
    EXPECT_EQ(stray->kind, StrayKind::outside);
    EXPECT_EQ(stray->sphere, 1u);
    EXPECT_NEAR((stray->centre - world->frame.toMesh({0, 14, 0})).norm(), 0, 1e-12);
    EXPECT_DOUBLE_EQ(stray->time, 2 * world->frame.time);
    EXPECT_TRUE(world->clock.finished);
}

TEST_F(GuardTest, StopsTheRunForASphereFarBeyondTheGrid)
{
    world->spheres.add({1e9, 0, 0}, 1, 0);
    ASSERT_TRUE(found());
    EXPECT_EQ(world->clock.stray->kind, StrayKind::outside);
}

TEST(Guard, StopsTheRunForASphereInACavity)
{
    TriangleMesh mesh = shapes::box({-10, -10, -10}, {10, 10, 10});
    TriangleMesh cavity = shapes::box({-5, -5, -5}, {5, 5, 5});
    for (auto triangle : cavity.triangles)
    {
        std::swap(triangle[1], triangle[2]);
        for (std::uint32_t& corner : triangle)
        {
            corner += static_cast<std::uint32_t>(mesh.vertices.size());
        }
        mesh.triangles.push_back(triangle);
    }
    mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
    const auto world = smallWorld(mesh);
    Guard guard(*world);
    world->spheres.add({7.5, 0, 0}, 1, 0);
    guard.check();
    EXPECT_FALSE(world->clock.stray);
    world->spheres.add({0, 1, 0}, 1, 0);
    guard.check();
    ASSERT_TRUE(world->clock.stray);
    EXPECT_EQ(world->clock.stray->sphere, 1u);
}

TEST_F(GuardTest, StopsTheRunForASphereThatComesToRestBehindAWall)
{
    addResting(*world, {0, 0, 0});
    EXPECT_FALSE(found());
    addResting(*world, {0, -10.25, 0});
    ASSERT_TRUE(found());
    EXPECT_EQ(world->clock.stray->kind, StrayKind::outside);
    EXPECT_EQ(world->clock.stray->sphere, 1u);
}

TEST_F(GuardTest, StopsTheRunForASphereFasterThanAnyFall)
{
    world->spheres.add({0, 0, 0}, 1, 0);
    world->spheres.running().velocity[0] = {90, 0, 0}; // a fall through the box gives 8.3
    ASSERT_TRUE(found());
    EXPECT_EQ(world->clock.stray->kind, StrayKind::tooFast);
}

TEST_F(GuardTest, StopsTheRunForWhatIsNoNumber)
{
    world->spheres.add({0, 0, 0}, 1, 0);
    world->spheres.running().velocity[0] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
    ASSERT_TRUE(found());
    EXPECT_EQ(world->clock.stray->kind, StrayKind::notFinite);
}

TEST_F(GuardTest, AFallWithNothingBelowEndsWhereItBegan)
{
    const DropAndRoll dropAndRoll(*world);
    Eigen::Vector3d inside = {0, 0, 0};
    EXPECT_TRUE(dropAndRoll.drop(inside, 1));
    EXPECT_NEAR(inside.y(), -9, 1e-9);
    Eigen::Vector3d outside = {0, -11.2, 0};
    EXPECT_FALSE(dropAndRoll.drop(outside, 1));
    EXPECT_EQ(outside.y(), -11.2);
}

} // namespace
} // namespace frostfill
