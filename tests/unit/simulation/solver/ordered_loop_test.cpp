// SPDX-License-Identifier: MIT
#include "simulation/solver/ordered_loop.hpp"

#include "base/random.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace frostfill
{
namespace
{

/// Two thousand runners in a box, some ten near each, in an order by chance.
class OrderedLoopTest : public ::testing::TestWithParam<int>
{
protected:
    OrderedLoopTest()
    {
        for (std::uint64_t k = 0; k < 2000; ++k)
        {
            const auto at = [&](std::uint64_t axis) { return 18 * uniformRandom(5, k, axis) - 9; };
            world->spheres.add({at(0), at(1), at(2)}, 0.9, 0);
        }
        pairs.findPairs();
        rows.resize(world->spheres.running().size());
        std::iota(rows.begin(), rows.end(), 0u);
        std::sort(rows.begin(), rows.end(),
                  [](std::uint32_t a, std::uint32_t b)
                  { return uniformRandom(6, a, 0) < uniformRandom(6, b, 0); });
        rank.resize(rows.size());
        for (std::uint32_t k = 0; k < rows.size(); ++k)
        {
            rank[rows[k]] = k;
        }
    }

    /// A Gauss-Seidel sweep of something that forgets nothing of who came when.
    std::vector<double> sweep(OrderedLoop& loop, std::span<const std::uint32_t> some) const
    {
        std::vector<double> value(rows.size());
        std::iota(value.begin(), value.end(), 1.0);
        loop.forEach(some, rank,
                     [&](std::uint32_t row)
                     {
                         double sum = value[row];
                         for (const std::uint32_t other : pairs.nearby(row))
                         {
                             sum = std::fmod(1.7 * sum + value[other], 1000.0);
                         }
                         value[row] = sum;
                     });
        return value;
    }

    std::unique_ptr<World> world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}));
    RunnerGrid grid{world->spheres.resting().frame()};
    Threads alone{1};
    BroadPhase pairs{world->spheres.running(), grid, alone};
    std::vector<std::uint32_t> rows;
    std::vector<std::uint32_t> rank;
};

TEST_P(OrderedLoopTest, GivesTheResultOfOneThread)
{
    OrderedLoop plain(pairs, alone);
    const std::vector<double> expected = sweep(plain, rows);
    Threads threads(GetParam());
    OrderedLoop loop(pairs, threads);
    for (int time = 0; time < 20; ++time)
    {
        ASSERT_EQ(sweep(loop, rows), expected) << time;
    }
}

TEST_P(OrderedLoopTest, WaitsForNobodyWhoIsNotAmongTheRows)
{
    const std::vector<std::uint32_t> some(rows.begin(), rows.begin() + 700);
    for (std::size_t k = some.size(); k < rows.size(); ++k)
    {
        rank[rows[k]] = 0xffffffff;
    }
    OrderedLoop plain(pairs, alone);
    Threads threads(GetParam());
    OrderedLoop loop(pairs, threads);
    EXPECT_EQ(sweep(loop, some), sweep(plain, some));
}

// Those after it never come to their turn: nobody may wait for them.
TEST_P(OrderedLoopTest, ThrowsWhatAVisitThrowsAndGoesOn)
{
    Threads threads(GetParam());
    OrderedLoop loop(pairs, threads);
    const std::uint32_t fatal = rows[rows.size() / 3];
    const auto visit = [&](std::uint32_t row)
    {
        if (row == fatal)
        {
            throw std::runtime_error("a visit");
        }
    };
    EXPECT_THROW(loop.forEach(rows, rank, visit), std::runtime_error);
    OrderedLoop plain(pairs, alone);
    EXPECT_EQ(sweep(loop, rows), sweep(plain, rows));
}

INSTANTIATE_TEST_SUITE_P(Threads, OrderedLoopTest, ::testing::Values(2, 4, 16));

} // namespace
} // namespace frostfill
