// SPDX-License-Identifier: MIT
#include "bulk/bed_top.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kNothing = -std::numeric_limits<double>::infinity();

TEST(BedTop, OfASquareLatticeIsLevelWithItsTops)
{
    std::vector<Eigen::Vector3d> centres;
    for (int layer = 0; layer < 3; ++layer)
    {
        for (int row = 0; row < 6; ++row)
        {
            for (int column = 0; column < 5; ++column)
            {
                centres.emplace_back(1 + 2 * column, 7 + 2 * row, -3 + 2 * layer);
            }
        }
    }
    const std::vector<double> radii(centres.size(), 1);
    const BedTop top(2, centres, radii);
    for (double x = 0.01; x < 10; x += 0.13)
    {
        for (double y = 6.01; y < 18; y += 0.17)
        {
            ASSERT_EQ(top.over({x, y, 40}), 2) << x << ' ' << y;
        }
    }
    EXPECT_EQ(top.highest(), 2);
    EXPECT_EQ(top.depth({5, 9, -1.5}), 3.5);
    EXPECT_EQ(top.over({1, 25, 0}), kNothing);
    EXPECT_EQ(top.over({-20, 7, 0}), kNothing);
}

// Each sphere ends the bed as far as 1.5 of its radii, and at most by a cell's diagonal farther.
TEST(BedTop, IsTheHighestTopOfTheSpheresThatAreNear)
{
    const std::vector<Eigen::Vector3d> centres = {{0, 0, 0}, {0, -9, 3}, {30, 5, 0}, {34, 1, 2}};
    const std::vector<double> radii = {2, 0.5, 6, 1};
    const double diagonal = std::sqrt(2.0) / 2 * (9.5 / 4);
    const BedTop top(1, centres, radii);
    for (double x = -5; x < 45; x += 0.37)
    {
        for (double z = -12; z < 12; z += 0.41)
        {
            const auto highest = [&](double beyond)
            {
                double height = kNothing;
                for (std::size_t k = 0; k < radii.size(); ++k)
                {
                    if (std::hypot(x - centres[k].x(), z - centres[k].z()) <=
                        BedTop::kReach * radii[k] + beyond)
                    {
                        height = std::max(height, centres[k].y() + radii[k]);
                    }
                }
                return height;
            };
            const double found = top.over({x, 0, z});
            EXPECT_GE(found, highest(0)) << x << ' ' << z;
            EXPECT_LE(found, highest(diagonal)) << x << ' ' << z;
        }
    }
}

TEST(BedTop, IsALevelPlaneIfAsked)
{
    const BedTop top(0, 2.5);
    EXPECT_EQ(top.depth({1, 80, -90}), 1.5);
    EXPECT_EQ(top.depth({3, 0, 0}), -0.5);
    EXPECT_EQ(top.highest(), 2.5);
}

// Two grains of dust far apart would need more cells than there is memory for.
TEST(BedTop, TakesLittleMemoryForFewSpheresFarApart)
{
    const std::vector<Eigen::Vector3d> centres = {{0, 0, 0}, {1e6, 1e6, 1}};
    const std::vector<double> radii = {1, 1};
    const BedTop top(2, centres, radii);
    EXPECT_EQ(top.over({0, 0, 0}), 1);
    EXPECT_EQ(top.over({1e6, 1e6, 0}), 2);
    EXPECT_EQ(top.over({5e5, 5e5, 0}), kNothing);
}

} // namespace
} // namespace frostfill
