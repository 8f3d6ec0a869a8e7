// SPDX-License-Identifier: MIT
// The judge of all spheres together, on packings placed by hand.
#include "simulation/quality/equilibrium.hpp"

#include "oracle/rest.hpp"
#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/tolerances.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// A sphere on three on the floor of the room.
HandPacking pyramidInRoom(double scale = 1)
{
    HandPacking packing;
    for (const Vector3d& place : oracle::threeTouching(-9))
    {
        packing.add(scale * place, scale);
    }
    packing.add(scale * Vector3d(0, -9 + oracle::aboveThree(), 0), scale);
    return packing;
}

TEST(Equilibrium, IsNotJudgedUnlessAFrictionIsGiven)
{
    EXPECT_FALSE(pyramidInRoom().in(room()).equilibrium.has_value());
}

TEST(Equilibrium, SaysWhetherAPyramidStandsUnderTheFrictionGiven)
{
    const double least = oracle::frictionOfPyramid(3);
    for (const double factor : {0.9, 1.02})
    {
        const QualityReport report =
            pyramidInRoom().in(room(), Axis::y, {.friction = factor * least, .unbalance = 1e-3});
        const EquilibriumReport& joint = report.equilibrium.value();
        EXPECT_EQ(report.unsupported, 0U) << "each by itself is carried";
        EXPECT_EQ(joint.friction, factor * least);
        EXPECT_EQ(joint.spheres, 4U);
        EXPECT_EQ(joint.unbalanced > 0, factor < 1) << factor;
        EXPECT_EQ(joint.largest > 1e-3, factor < 1) << factor;
        EXPECT_TRUE(joint.settled);
        EXPECT_NEAR(joint.leastFriction, least, 0.01 * least);
    }
}

TEST(Equilibrium, AllowsATenthOfTheWeightUnlessAnotherShareIsGiven)
{
    const double fine = pyramidInRoom()
                            .in(room(), Axis::y, {.friction = 0, .unbalance = 1e-3})
                            .equilibrium->leastFriction;
    const double coarse =
        pyramidInRoom().in(room(), Axis::y, {.friction = 0}).equilibrium->leastFriction;
    EXPECT_LT(coarse, 0.9 * fine);
    EXPECT_GT(coarse, 0.3 * fine);
}

TEST(Equilibrium, ChecksRunningSpheresNeitherAsBodiesNorAsSupport)
{
    HandPacking packing;
    packing.addRunning({0, -9, 0}).add({0, -7, 0}).add({5, -9, 0});
    const EquilibriumReport joint =
        packing.in(room(), Axis::y, {.friction = 1}).equilibrium.value();
    EXPECT_EQ(joint.spheres, 2U);
    EXPECT_EQ(joint.unbalanced, 1U);
    EXPECT_EQ(joint.largest, 1);
    EXPECT_EQ(joint.leastFriction, std::numeric_limits<double>::infinity());
}

TEST(Equilibrium, LetsOneInAHundredFall)
{
    for (const int floating : {1, 2})
    {
        HandPacking packing;
        for (int k = 0; k < floating; ++k)
        {
            packing.add({0, 3.0 * k, 0});
        }
        for (int k = 0; k < 100; ++k) // on the floor, apart from each other
        {
            const int row = k / 10;
            packing.add({1.7 * (k % 10) - 7.6, -9.2, 1.7 * row - 7.6}, 0.8);
        }
        const EquilibriumReport joint =
            packing.in(room(), Axis::y, {.friction = 0}).equilibrium.value();
        EXPECT_EQ(joint.unbalanced, floating);
        EXPECT_EQ(joint.leastFriction, floating == 1 ? 0 : std::numeric_limits<double>::infinity());
    }
}

TEST(ContactNetwork, HasEachPairOnceAndEachWallForEachSphere)
{
    const auto world = smallWorld(room());
    addResting(*world, {-9, -9, 0});    // in an edge of the room
    addResting(*world, {-7, -9, 0});    // touches it
    addResting(*world, {-7, -6.98, 0}); // a gap of two hundredths of r: none
    world->spheres.add({-5, -9, 0}, 1, 0);
    Threads threads(1);
    const ContactNetwork network = networkAtRest(*world, threads);
    ASSERT_EQ(network.bodies.size(), 3U);
    EXPECT_EQ(network.bodies[0].pull, Vector3d(0, -1, 0));
    std::size_t pairs = 0;
    std::size_t walls = 0;
    for (const auto& [normal, upon, from] : network.contacts)
    {
        EXPECT_NEAR(normal.norm(), 1, 1e-14);
        if (from == ContactNetwork::kWall)
        {
            ++walls;
            EXPECT_TRUE(normal.isApprox(Vector3d(1, 0, 0)) || normal.isApprox(Vector3d(0, 1, 0)));
            continue;
        }
        ++pairs;
        const Vector3d apart = world->spheres.position(upon) - world->spheres.position(from);
        EXPECT_TRUE(normal.isApprox(apart.normalized()));
    }
    EXPECT_EQ(pairs, 1U);
    EXPECT_EQ(walls, 3U);
}

TEST(ContactNetwork, MeasuresGapsInTheSmallerRadiusWhicheverCameFirst)
{
    for (const double share : {0.9, 1.1})
    {
        for (const bool smallFirst : {false, true})
        {
            const auto world = smallWorld(room());
            const double gap = share * kContactGap * 0.5;
            const std::array radii = {smallFirst ? 0.5 : 1, smallFirst ? 1 : 0.5};
            world->spheres.addResting({0, 0, 0}, radii[0], 0);
            world->spheres.addResting({1.5 + gap, 0, 0}, radii[1], 0);
            Threads threads(1);
            EXPECT_EQ(networkAtRest(*world, threads).contacts.size(), share < 1 ? 1U : 0U)
                << share << smallFirst;
        }
    }
}

} // namespace
} // namespace frostfill
