// SPDX-License-Identifier: MIT
#include "simulation/settling/settling.hpp"

#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "simulation/quality/equilibrium.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

std::unique_ptr<World> worldWithFriction(double friction, double wallFriction)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 1;
    scene.spheres.count.reset();
    scene.rest = {Rest::joint, friction, wallFriction, 0};
    return std::make_unique<World>(scene, room());
}

void settle(Settling& settling)
{
    settling.wakeAll();
    settling.begin();
    while (!settling.step())
    {
    }
}

/// Three on the floor that touch each other, and one on them.
std::unique_ptr<World> pyramid(double friction)
{
    auto world = worldWithFriction(friction, friction);
    for (const Vector3d& place : oracle::threeTouching(-9))
    {
        addResting(*world, place);
    }
    addResting(*world, {0, -9 + oracle::aboveThree(), 0});
    return world;
}

TEST(Settling, LetsAPyramidStandOrFallAtTheFrictionOfStatics)
{
    for (const double factor : {0.8, 1.02})
    {
        const auto world = pyramid(factor * oracle::frictionOfPyramid());
        Threads alone(1);
        Settling settling(*world, alone);
        settle(settling);
        const double sunk = -9 + oracle::aboveThree() - world->spheres.position(3).y();
        EXPECT_EQ(sunk<0.01, factor> 1) << sunk;
        EXPECT_TRUE(world->clock.settling.settled);
    }
}

// What is missing on it is less than on many that are at rest, and it is one of a hundred.
TEST(Settling, IsNotOverBeforeASphereHasRolledOffTwoOthers)
{
    const auto world = worldWithFriction(0.5, 0.5);
    const auto addLayer = [&](int columns, int rows, const Vector3d& corner)
    {
        for (int k = 0; k < columns * rows; ++k)
        {
            addResting(*world, corner + 2 * Eigen::Vector3i(k / rows, 0, k % rows).cast<double>());
        }
    };
    addLayer(7, 8, {-9, -9, -9});
    addLayer(6, 7, {-8, -9 + std::sqrt(2.0), -8});
    addResting(*world, {8, -9, 1});
    addResting(*world, {8, -9, -1});
    const auto top = addResting(*world, {8 - 0.005, -9 + std::sqrt(3.0), 0});
    Threads alone(1);
    Settling settling(*world, alone);
    settle(settling);
    EXPECT_NEAR(world->spheres.position(top).y(), -9, 1e-4);
    EXPECT_TRUE(world->clock.settling.settled);
}

TEST(Settling, WithoutFrictionLetsAPyramidLieDown)
{
    const auto world = pyramid(0);
    Threads alone(1);
    Settling settling(*world, alone);
    settle(settling);
    for (std::uint32_t id = 0; id < 4; ++id)
    {
        EXPECT_NEAR(world->spheres.position(id).y(), -9, 1e-4) << id;
        EXPECT_EQ(world->spheres.state(id), SphereState::frozen);
    }
}

/// A heap of spheres in a corner of the room, loosely put.
std::unique_ptr<World> heap(double friction)
{
    auto world = worldWithFriction(friction, friction);
    for (int k = 0; k < 150; ++k)
    {
        const Vector3d site = Eigen::Vector3i(k % 5, k / 25, k / 5 % 5).cast<double>();
        addResting(*world, Vector3d(-8.9, -8.9, -8.9) + 2.05 * site +
                               0.01 * Vector3d(k * 7 % 5 - 2, 0, k * 3 % 5 - 2));
    }
    return world;
}

TEST(Settling, EndsInWhatTheJudgeFindsBalancedAndApart)
{
    for (const double friction : {0.0, 0.4})
    {
        const auto world = heap(friction);
        world->scene.judge.friction = friction;
        Threads alone(1);
        Settling settling(*world, alone);
        settle(settling);
        ASSERT_TRUE(world->clock.settling.settled) << friction;
        const QualityReport report = examine(*world);
        EXPECT_LE(report.maxOverlap, kOverlapAtRest);
        EXPECT_LE(report.maxWallOverlap, kOverlapAtRest);
        EXPECT_EQ(report.unsupported, 0U);
        EXPECT_EQ(report.centresOutside, 0U);
        ASSERT_TRUE(report.equilibrium);
        EXPECT_EQ(report.equilibrium->unbalanced, 0U) << report.equilibrium->largest;
        EXPECT_LT(report.energyGain, 1e-6);
    }
}

TEST(Settling, MovesNothingThatHasSettledAndLetsOnlyWhatIsNewComeToRest)
{
    const auto world = heap(0.4);
    Threads alone(1);
    Settling settling(*world, alone);
    settle(settling);
    std::vector<Vector3d> before;
    for (std::uint32_t id = 0; id < world->spheres.size(); ++id)
    {
        before.push_back(world->spheres.position(id));
    }
    const auto added = addResting(*world, {8.9, -8.5, -8.9});
    const auto farthest = [&]
    {
        double most = 0;
        for (std::uint32_t id = 0; id < before.size(); ++id)
        {
            most = std::max(most, (world->spheres.position(id) - before[id]).norm());
        }
        return most;
    };
    settling.wakeAll();
    settling.begin();
    EXPECT_FALSE(settling.step());
    EXPECT_LT(farthest(), 1e-4) << "contacts hold what they held";
    while (!settling.step())
    {
    }
    EXPECT_LT(farthest(), 1e-4);
    EXPECT_NEAR(world->spheres.position(added).y(), -9, 1e-4);
    EXPECT_EQ(world->clock.settling.rounds, 2U);
}

TEST(Settling, TakesWallsToBeAsRoughAsTheirOwnFriction)
{
    for (const double wallFriction : {0.0, 1.0})
    {
        const auto world = worldWithFriction(1, wallFriction);
        for (const Vector3d& place : oracle::threeTouching(-9))
        {
            addResting(*world, place);
        }
        addResting(*world, {0, -9 + oracle::aboveThree(), 0});
        Threads alone(1);
        Settling settling(*world, alone);
        settle(settling);
        EXPECT_EQ(world->spheres.position(3).y() < -8.9, wallFriction == 0);
    }
}

} // namespace
} // namespace frostfill
