// SPDX-License-Identifier: MIT
#include "simulation/motion/drop_and_roll.hpp"

#include "oracle/rest.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

/// A prism along z whose cross-section is a V with walls at `angle` from the vertical, open to a
/// lid.
TriangleMesh groove(double angle)
{
    const double h = 10;
    const double w = h * std::tan(angle);
    TriangleMesh mesh;
    for (const double z : {-10.0, 10.0})
    {
        mesh.vertices.emplace_back(0, 0, z);
        mesh.vertices.emplace_back(w, h, z);
        mesh.vertices.emplace_back(-w, h, z);
    }
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                      {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

class Settling : public ::testing::Test
{
protected:
    Eigen::Vector3d settle(World& world, Eigen::Vector3d p)
    {
        DropAndRoll descent(world);
        EXPECT_TRUE(descent.settle(p, 1));
        return p;
    }
};

TEST_F(Settling, RestsOnTheFloorAtItsRadius)
{
    const auto world = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}, 4));
    const Eigen::Vector3d p = settle(*world, {0.3, 3.1, -0.4});
    EXPECT_NEAR(p.y(), -4, 1e-9);
    EXPECT_EQ(p.x(), 0.3);
    EXPECT_EQ(p.z(), -0.4);
}

TEST_F(Settling, RestsOnThreeTouchingSpheres)
{
    const auto world = smallWorld(shapes::box({-8, -8, -8}, {8, 8, 8}));
    for (const Eigen::Vector3d& place : oracle::threeTouching(-7))
    {
        addResting(*world, place);
    }
    const Eigen::Vector3d p = settle(*world, {0.2, 0, 0.1});
    EXPECT_NEAR(p.y(), -7 + oracle::aboveThree(), 1e-7);
    EXPECT_NEAR(p.x(), 0, 1e-7);
    EXPECT_NEAR(p.z(), 0, 1e-7);
}

TEST_F(Settling, RestsInAGroove)
{
    for (const double angle : {0.3, 0.6, 1.0})
    {
        const auto world = smallWorld(groove(angle));
        const double centre = 5;
        const Eigen::Vector3d p = settle(*world, {0.2, 2, 0.5});
        EXPECT_NEAR(p.y() + centre, oracle::aboveTip(angle), 1e-6) << angle;
        EXPECT_NEAR(p.x(), 0, 1e-6) << angle;
    }
}

TEST_F(Settling, RollsOffAPlateauOfOneSphereAndNeverHangs)
{
    const auto world = smallWorld(shapes::box({-6, -6, -6}, {6, 6, 6}, 3));
    addResting(*world, {0, -5, 0});
    const Eigen::Vector3d p = settle(*world, {0.01, 2, 0.02});
    EXPECT_NEAR(p.y(), -5, 1e-9);
    EXPECT_GE((p - Eigen::Vector3d(0, -5, 0)).norm(), 2 - 1e-12);
}

} // namespace
} // namespace frostfill
