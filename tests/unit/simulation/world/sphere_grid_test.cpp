// SPDX-License-Identifier: MIT
#include "simulation/world/sphere_grid.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

TEST(SphereGrid, FindsAllInABallAndFewOthers)
{
    SphereGrid grid({{-8, -8, -8}, 2, {8, 8, 8}});
    std::vector<Eigen::Vector3d> centres;
    for (std::uint64_t k = 0; k < 2000; ++k)
    {
        const auto along = [&](std::uint64_t axis) { return 17 * uniformRandom(8, k, axis) - 8.5; };
        centres.emplace_back(along(0), along(1), along(2)); // some beyond the grid
        grid.insert(static_cast<std::uint32_t>(k), centres.back(), 1);
    }
    std::size_t within = 0;
    std::size_t met = 0;
    for (std::uint64_t k = 0; k < 500; ++k)
    {
        const auto along = [&](std::uint64_t axis) { return 18 * uniformRandom(9, k, axis) - 9; };
        const Eigen::Vector3d p(along(0), along(1), along(2));
        const double reach = k % 2 == 0 ? 2 : 2.5;
        std::vector<int> visits(centres.size(), 0);
        grid.forEachNear(p, reach, [&](std::uint32_t row) { ++visits[row]; });
        for (std::size_t row = 0; row < centres.size(); ++row)
        {
            const bool isWithin = (centres[row] - p).norm() <= reach;
            ASSERT_TRUE(visits[row] == 1 || (visits[row] == 0 && !isWithin)) << k << ' ' << row;
            within += isWithin ? 1 : 0;
            met += static_cast<std::size_t>(visits[row]);
        }
    }
    EXPECT_GT(within, 3000u);
    EXPECT_LT(met, 6 * within); // those of the cells of a cube
}

TEST(SphereGrid, IsClearWhereNoSphereIsInTheWay)
{
    SphereGrid grid({{-8, -8, -8}, 2, {8, 8, 8}});
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
    for (std::uint64_t k = 0; k < 300; ++k) // some share a cell
    {
        const auto along = [&](std::uint64_t axis) { return 16 * uniformRandom(6, k, axis) - 8; };
        centres.emplace_back(along(0), along(1), along(2));
        radii.push_back(k % 3 == 0 ? 0.4 : 1);
        grid.insert(static_cast<std::uint32_t>(k), {0, 0, 0}, radii.back());
    }
    for (std::uint32_t row = 0; row < centres.size(); ++row)
    {
        grid.move(row, centres[row]);
    }
    std::size_t clear = 0;
    constexpr std::uint64_t kPlaces = 2000;
    for (std::uint64_t k = 0; k < kPlaces; ++k)
    {
        const auto along = [&](std::uint64_t axis) { return 16 * uniformRandom(7, k, axis) - 8; };
        const Eigen::Vector3d place(along(0), along(1), along(2));
        const double radius = k % 2 == 0 ? 1 : 0.4;
        bool isClear = true;
        for (std::size_t row = 0; row < centres.size(); ++row)
        {
            const double contact = radii[row] + radius + kClearance;
            isClear = isClear && (centres[row] - place).norm() >= contact;
        }
        ASSERT_EQ(isClearOf(grid, place, radius), isClear) << k;
        clear += isClear ? 1 : 0;
    }
    EXPECT_GT(clear, kPlaces / 10);
    EXPECT_LT(clear, kPlaces - kPlaces / 10);
    grid.clear();
    EXPECT_TRUE(isClearOf(grid, centres.front(), 1)) << "nothing is left in any cell";
}

} // namespace
} // namespace frostfill
