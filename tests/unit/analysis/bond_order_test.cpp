// SPDX-License-Identifier: MIT
#include "analysis/bond_order.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

std::vector<Eigen::Vector3d> randomDirections(std::size_t count)
{
    std::vector<Eigen::Vector3d> directions;
    for (std::uint64_t k = 0; directions.size() < count; ++k)
    {
        const Eigen::Vector3d place(2 * uniformRandom(5, k, 0) - 1, 2 * uniformRandom(5, k, 1) - 1,
                                    2 * uniformRandom(5, k, 2) - 1);
        if (place.norm() <= 1 && place.norm() > 0.1)
        {
            directions.push_back(place.normalized());
        }
    }
    return directions;
}

/// By the addition theorem: the mean of Legendre's polynomial of the angles between all bonds.
double q6ByAngles(const std::vector<Eigen::Vector3d>& directions)
{
    double sum = 0;
    for (const Eigen::Vector3d& a : directions)
    {
        for (const Eigen::Vector3d& b : directions)
        {
            sum += std::legendre(6, std::clamp(a.dot(b), -1.0, 1.0));
        }
    }
    return std::sqrt(sum) / static_cast<double>(directions.size());
}

TEST(BondOrder, IsWhatTheAnglesBetweenBondsSay)
{
    for (const std::size_t count : {1U, 2U, 5U, 13U, 60U})
    {
        const std::vector<Eigen::Vector3d> directions = randomDirections(count);
        BondOrder6 order;
        for (const Eigen::Vector3d& direction : directions)
        {
            order.add(direction);
        }
        EXPECT_NEAR(order.q6(), q6ByAngles(directions), 1e-12) << count;
        EXPECT_EQ(order.bonds(), count);
    }
}

TEST(BondOrder, IsOneAlongALineAndNothingWithoutBonds)
{
    BondOrder6 order;
    EXPECT_EQ(order.q6(), 0);
    const Eigen::Vector3d along = Eigen::Vector3d(1, 2, -2) / 3;
    order.add(along);
    order.add(-along);
    EXPECT_NEAR(order.q6(), 1, 1e-14);
}

TEST(BondOrder, OfTwoPartsIsThatOfAll)
{
    const std::vector<Eigen::Vector3d> directions = randomDirections(20);
    BondOrder6 all;
    BondOrder6 parts[2];
    for (std::size_t k = 0; k < directions.size(); ++k)
    {
        all.add(directions[k]);
        parts[k % 2].add(directions[k]);
    }
    parts[0].add(parts[1]);
    EXPECT_NEAR(parts[0].q6(), all.q6(), 1e-14);
    EXPECT_EQ(parts[0].bonds(), 20U);
}

} // namespace
} // namespace frostfill
