// SPDX-License-Identifier: MIT
#include "geometry/bricked_cells.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace frostfill
{
namespace
{

/// Whole numbers below a limit.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : seed_(seed) {}
    int below(int limit) { return static_cast<int>(uniformRandom(seed_, 0, draws_++) * limit); }
    GridPlace place(const GridPlace& count)
    {
        const int x = below(count[0]);
        const int y = below(count[1]);
        return {x, y, below(count[2])};
    }

private:
    std::uint64_t seed_;
    std::uint64_t draws_ = 0;
};

// Against a map: with a table of all, with a hash table, and where places lie far apart.
TEST(BrickTable, NumbersBricksInTheOrderInWhichTheyComeAndFindsEach)
{
    for (const auto& [count, smallBox] :
         {std::pair<GridPlace, std::size_t>{{9, 7, 5}, 1000},
          {{9, 7, 5}, 0},
          {{2'000'000'000, 2'000'000'000, 2'000'000'000}, BrickTable::kSmallBox}})
    {
        BrickTable table(count, smallBox);
        std::map<GridPlace, std::uint32_t> expected;
        Dice dice(7);
        for (int k = 0; k < 3000; ++k)
        {
            const GridPlace p = dice.place(count);
            const auto known = expected.find(p);
            ASSERT_EQ(table.find(p[0], p[1], p[2]),
                      known == expected.end() ? BrickTable::kNone : known->second);
            if (k % 2 == 0)
            {
                const auto number = static_cast<std::uint32_t>(expected.size());
                const std::uint32_t its = expected.try_emplace(p, number).first->second;
                ASSERT_EQ(table.obtain(p[0], p[1], p[2]), its);
                ASSERT_EQ(table.place(its), p);
            }
        }
        ASSERT_EQ(table.size(), expected.size());
        for (const auto& [p, number] : expected)
        {
            ASSERT_EQ(table.find(p[0], p[1], p[2]), number);
        }
    }
}

// Against a dense grid of the same numbers: every cell of a brick that was asked for, in the order
// of the grid, for ranges of a few bricks and of many.
template <int Length>
void expectCellsInOrder(std::size_t oneBrick, std::size_t smallBox)
{
    const GridPlace count = {21, 18, 13};
    BrickedCells<Length> cells(count, oneBrick, smallBox);
    Dice dice(11);
    std::set<GridPlace> bricks;
    const auto brickOf = [](const GridPlace& c) {
        return GridPlace{c[0] / Length, c[1] / 4, c[2] / 4};
    };
    for (int k = 0; k < 25; ++k)
    {
        const GridPlace p = dice.place(count);
        const std::size_t number = cells.obtain(p[0], p[1], p[2]);
        ASSERT_EQ(cells.find(p[0], p[1], p[2]), number);
        ASSERT_LT(number, cells.size());
        ASSERT_TRUE(oneBrick > 0 || cells.cell(number) == p);
        bricks.insert(brickOf(p));
    }
    for (int k = 0; k < 300; ++k)
    {
        GridPlace low = dice.place(count);
        GridPlace high = low;
        for (int axis = 0; axis < 3; ++axis)
        {
            high[axis] += dice.below(k % 2 == 0 ? 3 : 30);
            high[axis] = std::min(high[axis], count[axis] - 1);
        }
        std::vector<std::size_t> expected;
        for (int z = low[2]; z <= high[2]; ++z)
        {
            for (int y = low[1]; y <= high[1]; ++y)
            {
                for (int x = low[0]; x <= high[0]; ++x)
                {
                    const bool isThere = oneBrick > 0 || bricks.count(brickOf({x, y, z})) != 0;
                    ASSERT_EQ(cells.find(x, y, z) != BrickedCells<Length>::kNone, isThere);
                    if (isThere)
                    {
                        expected.push_back(cells.find(x, y, z));
                    }
                }
            }
        }
        std::vector<std::size_t> visited;
        cells.forEachIn(low, high, [&](std::size_t cell) { visited.push_back(cell); });
        ASSERT_EQ(visited, expected);
        visited.clear();
        cells.forEachInLarge(low, high, [&](std::size_t cell) { visited.push_back(cell); });
        ASSERT_EQ(std::multiset<std::size_t>(visited.begin(), visited.end()),
                  std::multiset<std::size_t>(expected.begin(), expected.end()));
        ASSERT_EQ(std::set<std::size_t>(expected.begin(), expected.end()).size(), expected.size());
    }
}

TEST(BrickedCells, AreVisitedInTheOrderOfTheGrid)
{
    expectCellsInOrder<4>(BrickedCells<>::kOneBrick, BrickTable::kSmallBox);
    expectCellsInOrder<4>(0, BrickTable::kSmallBox);
    expectCellsInOrder<4>(0, 0);
    expectCellsInOrder<1>(0, 0);
}

TEST(BrickedCells, TakeMemoryByWhatIsAskedFor)
{
    BrickedCells<> cells({1 << 20, 1 << 20, 1 << 20});
    EXPECT_EQ(cells.size(), 0u);
    (void)cells.obtain(123456, 7, 1 << 19);
    (void)cells.obtain(123457, 6, (1 << 19) + 3);
    EXPECT_EQ(cells.size(), 64u);
    EXPECT_EQ(BrickedCells<>({100, 100, 100}).size(), 1'000'000u);
}

} // namespace
} // namespace frostfill
