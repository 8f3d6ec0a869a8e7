// SPDX-License-Identifier: MIT
#include "bulk/bulk.hpp"

#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

/// Spheres of radius 1 in a room twenty across, in layers of `height`, up to y = `top`; every other
/// layer is shifted by `shift` along x and z.
std::vector<Eigen::Vector3d> latticeOfSpheres(double across, double height, double shift,
                                              double top)
{
    std::vector<Eigen::Vector3d> centres;
    int layer = 0;
    for (double y = -9; y <= top; y += height, ++layer)
    {
        const double from = layer % 2 == 0 ? -9 : -9 + shift;
        for (double x = from; x < 9.1; x += across)
        {
            for (double z = from; z < 9.1; z += across)
            {
                centres.emplace_back(x, y, z);
            }
        }
    }
    return centres;
}

double fractionOf(const std::vector<Eigen::Vector3d>& centres, double ceiling = 10)
{
    const auto world = smallWorld(shapes::box({-10, -10, -10}, {10, ceiling, 10}));
    const Eigen::Vector3d middle(0, (ceiling - 10) / 2, 0); // the origin of the world
    std::vector<Eigen::Vector3d> moved;
    for (const Eigen::Vector3d& centre : centres)
    {
        moved.push_back(centre - middle);
    }
    Threads threads(1);
    const Bulk bulk(world->surface, world->inside, 1, 1, threads);
    return bulk.fraction(moved, std::vector<double>(moved.size(), 1)).value_or(-1);
}

TEST(Bulk, OfACubicLatticeHasItsFraction)
{
    EXPECT_NEAR(fractionOf(latticeOfSpheres(2, 2, 0, 9)), std::numbers::pi / 6, 0.006);
}

TEST(Bulk, OfTheDensestLatticeHasItsFraction)
{
    const double root = std::sqrt(2.0);
    EXPECT_NEAR(fractionOf(latticeOfSpheres(2, root, 1, 9)), std::numbers::pi / (3 * root), 0.006);
}

TEST(Bulk, EndsFourRadiiBelowTheSurface)
{
    EXPECT_NEAR(fractionOf(latticeOfSpheres(2, 2, 0, 1)), std::numbers::pi / 6, 0.006);
    EXPECT_NEAR(fractionOf(latticeOfSpheres(2, 2, 0, 1), 30), std::numbers::pi / 6, 0.006);
    EXPECT_FALSE(isInBulk(4, 3.9, 1));
    EXPECT_FALSE(isInBulk(3.9, 4, 1));
    EXPECT_TRUE(isInBulk(4, 4, 1));
    EXPECT_FALSE(isInBulk(4, 4, 1.1));
}

TEST(Bulk, IsNoneWhereNothingIsFarFromWalls)
{
    const auto world = smallWorld(shapes::box({-10, -3, -10}, {10, 3, 10}));
    Threads threads(1);
    const Bulk bulk(world->surface, world->inside, 1, 1, threads);
    EXPECT_FALSE(bulk.any());
    const std::vector<Eigen::Vector3d> one = {{0, 0, 0}};
    EXPECT_FALSE(bulk.fraction(one, std::vector<double>{1}));
    EXPECT_FALSE(bulk.fraction({}, {}));
}

} // namespace
} // namespace frostfill
