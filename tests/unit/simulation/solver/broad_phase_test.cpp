// SPDX-License-Identifier: MIT
// Pairs of runners against all pairs.

#include "simulation/solver/broad_phase.hpp"

#include "base/random.hpp"
#include "simulation/solver/tolerances.hpp"
#include "simulation/world/spheres.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

struct Runners
{
    void add(const Eigen::Vector3d& place, double radius) { spheres.add(place, radius, 0); }

    /// Whoever lies within the margin of each, one by one.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> expected() const
    {
        const RunningSpheres& running = spheres.running();
        std::vector<std::vector<std::uint32_t>> near(running.size());
        for (std::uint32_t a = 0; a < running.size(); ++a)
        {
            for (std::uint32_t b = 0; b < running.size(); ++b)
            {
                const double gap = (running.position[a] - running.position[b]).norm() -
                                   running.radius[a] - running.radius[b];
                if (a != b && gap < kPairMargin)
                {
                    near[a].push_back(b);
                }
            }
        }
        return near;
    }
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> found()
    {
        pairs.findPairs();
        std::vector<std::vector<std::uint32_t>> near;
        for (std::uint32_t row = 0; row < spheres.running().size(); ++row)
        {
            near.push_back(pairs.nearby(row));
            EXPECT_EQ(pairs.isPaired(row), !near[row].empty());
        }
        return near;
    }

    Spheres spheres;
    Threads threads{3};
    BroadPhase pairs{spheres.running(), threads};
};

/// Places in a box of that size, at the seed's choice.
void scatter(Runners& runners, std::size_t count, const Eigen::Vector3d& size, double smallest,
             std::uint64_t seed)
{
    for (std::uint64_t k = 0; k < count; ++k)
    {
        const auto at = [&](std::uint64_t axis) { return uniformRandom(seed, k, axis) - 0.5; };
        runners.add(size.cwiseProduct(Eigen::Vector3d(at(0), at(1), at(2))),
                    smallest + (1 - smallest) * uniformRandom(seed, k, 3));
    }
}

TEST(BroadPhase, FindsThePairsThatLookingAtAllFinds)
{
    std::uint64_t seed = 1;
    const std::vector<Eigen::Vector3d> sizes = {
        {6, 6, 6}, {30, 30, 30}, {300, 300, 300}, {80, 0, 80}, {0, 200, 0}, {0, 0, 0}, {40, 3, 7}};
    for (const Eigen::Vector3d& size : sizes)
    {
        for (const std::size_t count : {0U, 1U, 2U, 63U, 64U, 65U, 66U, 400U})
        {
            for (const double smallest : {1.0, 0.05})
            {
                SCOPED_TRACE(testing::Message() << count << " in " << size.transpose());
                Runners runners;
                scatter(runners, count, size, smallest, seed++);
                ASSERT_EQ(runners.found(), runners.expected());
            }
        }
    }
}

// Pairs whose distance is the margin but for rounding, in a row along each axis, so that cells end
// between them; and what is found has nothing of the search before.
TEST(BroadPhase, FindsPairsOnEitherSideOfABorder)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const double gap : {kPairMargin * (1 - 1e-12), kPairMargin * (1 + 1e-12)})
        {
            Runners runners;
            for (int k = 0; k < 100; ++k)
            {
                runners.add((2 + gap) * k * Eigen::Vector3d::Unit(axis), 1);
            }
            for (int repeat = 0; repeat < 2; ++repeat)
            {
                const auto found = runners.found();
                ASSERT_EQ(found, runners.expected());
                EXPECT_EQ(found[50].size(), gap < kPairMargin ? 2U : 0U);
            }
        }
    }
}

// A step that has gone wrong still has to come to its end, where the guard reports it.
TEST(BroadPhase, EndsWhereAPlaceIsNoNumber)
{
    for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300})
    {
        Runners runners;
        scatter(runners, 100, {12, 12, 12}, 1, 7);
        runners.spheres.running().position[40].y() = wrong;
        EXPECT_EQ(runners.found(), runners.expected());
    }
}

} // namespace
} // namespace frostfill
