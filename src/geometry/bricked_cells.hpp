// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/brick_table.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace frostfill
{

/// Numbers the cells of a grid, brick by brick, of those bricks that were asked for. What a search
/// keeps for each cell then takes memory by what is in the grid, not by the box around it. A small
/// grid is one brick, whose cells are numbered from the beginning, with x fastest.
///
/// A brick is four cells high and deep, and `Length` cells long.
template <int Length = 4>
class BrickedCells
{
public:
    static constexpr int kSide = 4; ///< of a brick along y and z [cells]
    static constexpr int kLength = Length;
    static constexpr std::size_t kInBrick = std::size_t{Length} * kSide * kSide;
    static constexpr std::size_t kNone = ~std::size_t{0};
    /// Cells up to which a grid is one brick. Larger: memory for cells without anything. Smaller:
    /// searches in ordinary objects look up bricks.
    static constexpr std::size_t kOneBrick = std::size_t{1} << 22;

    /// `oneBrick`: cells up to which it is one brick; 0: never.
    explicit BrickedCells(const GridPlace& count, std::size_t oneBrick = kOneBrick,
                          std::size_t smallBox = BrickTable::kSmallBox)
        : count_(count), isOne_(static_cast<double>(count[0]) * count[1] * count[2] <=
                                static_cast<double>(oneBrick)),
          bricks_(isOne_ ? GridPlace{0, 0, 0}
                         : GridPlace{bricksAlong(count[0], Length), bricksAlong(count[1], kSide),
                                     bricksAlong(count[2], kSide)},
                  smallBox)
    {
    }

    /// Cells that have a number: what is kept for each has as many entries.
    [[nodiscard]] std::size_t size() const
    {
        return isOne_ ? static_cast<std::size_t>(count_[0]) * count_[1] * count_[2]
                      : bricks_.size() * kInBrick;
    }
    /// kNone where no cell of the brick was asked for. The cell lies in the grid.
    [[nodiscard]] std::size_t find(int x, int y, int z) const
    {
        if (isOne_)
        {
            return inOne(x, y, z);
        }
        const std::uint32_t brick = bricks_.find(along(x, Length), along(y), along(z));
        return brick == BrickTable::kNone ? kNone : brick * kInBrick + inBrick(x, y, z);
    }
    /// Gives the cells of the brick numbers, unless they have some.
    std::size_t obtain(int x, int y, int z)
    {
        return isOne_ ? inOne(x, y, z)
                      : bricks_.obtain(along(x, Length), along(y), along(z)) * kInBrick +
                            inBrick(x, y, z);
    }

    /// Calls visit(number) for each cell from `low` to `high`, both included, that has one, with x
    /// fastest. Looks up each brick.
    template <class Visit>
    void forEachIn(const GridPlace& low, const GridPlace& high, Visit&& visit) const
    {
        for (int z = low[2]; z <= high[2]; ++z)
        {
            for (int y = low[1]; y <= high[1]; ++y)
            {
                forEachInRow(low[0], high[0], y, z, visit);
            }
        }
    }
    /// The same for one row of cells.
    template <class Visit>
    void forEachInRow(int low, int high, int y, int z, Visit&& visit) const
    {
        // Once for a small grid, and so that `visit` stands in one place only: it is inlined there.
        for (Run run = isOne_ ? Run{inOne(low, y, z), low, high} : runFrom(low, high, y, z);;
             run = runFrom(run.last + 1, high, y, z))
        {
            for (std::size_t cell = run.first; run.x <= run.last; ++run.x, ++cell)
            {
                visit(cell);
            }
            if (run.last >= high) [[likely]]
            {
                return;
            }
        }
    }
    /// The same for a range of more bricks than are in use: goes through those.
    template <class Visit>
    void forEachInLarge(const GridPlace& low, const GridPlace& high, Visit&& visit) const
    {
        isOne_ ? forEachIn(low, high, visit) : forEachOfThoseIn(low, high, visit);
    }

    [[nodiscard]] bool isOne() const { return isOne_; }
    /// Those that have numbers, unless the grid is one brick.
    [[nodiscard]] const BrickTable& bricks() const { return bricks_; }
    /// The first cell of a brick.
    [[nodiscard]] GridPlace firstCell(std::size_t brick) const
    {
        const GridPlace& place = bricks_.place(brick);
        return {place[0] * Length, place[1] * kSide, place[2] * kSide};
    }
    /// The brick that a cell lies in.
    [[nodiscard]] static GridPlace brickOf(const GridPlace& cell)
    {
        return {along(cell[0], Length), along(cell[1]), along(cell[2])};
    }
    /// Where the cell with this number lies.
    [[nodiscard]] GridPlace cell(std::size_t number) const
    {
        const GridPlace first = firstCell(number / kInBrick);
        const auto rest = static_cast<int>(number % kInBrick);
        return {first[0] + rest % Length, first[1] + rest / Length % kSide,
                first[2] + rest / (Length * kSide)};
    }
    [[nodiscard]] bool isInGrid(const GridPlace& cell) const
    {
        return cell[0] >= 0 && cell[0] < count_[0] && cell[1] >= 0 && cell[1] < count_[1] &&
               cell[2] >= 0 && cell[2] < count_[2];
    }

private:
    /// Which brick, of a coordinate that is never negative: a shift.
    static int along(int coordinate, unsigned side = kSide)
    {
        return static_cast<int>(static_cast<unsigned>(coordinate) / side);
    }
    static int bricksAlong(int cells, int side) { return (cells - 1) / side + 1; }
    [[nodiscard]] std::size_t inOne(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x;
    }
    [[nodiscard]] static std::size_t inBrick(int x, int y, int z)
    {
        const auto rest = [](int c, unsigned side) { return static_cast<unsigned>(c) % side; };
        return (rest(z, kSide) * kSide + rest(y, kSide)) * Length + rest(x, Length);
    }

    /// Cells from x to `last` of a row, which have numbers from `first` on. None when x > last.
    struct Run
    {
        std::size_t first;
        int x;
        int last;
    };
    [[nodiscard, gnu::noinline]] Run runFrom(int x, int high, int y, int z) const
    {
        const int last = std::min(high, x + Length - 1 - x % Length);
        const std::size_t first = find(x, y, z);
        return {first, first == kNone ? last + 1 : x, last};
    }

    template <class Visit>
    void forEachOfThoseIn(const GridPlace& low, const GridPlace& high, Visit& visit) const
    {
        const std::vector<std::uint32_t> order = bricksIn(low, high);
        const auto endOf = [&](std::size_t begin, int axis) // of bricks of one layer or row
        {
            std::size_t end = begin;
            while (end < order.size() &&
                   bricks_.place(order[end])[axis] == bricks_.place(order[begin])[axis])
            {
                ++end;
            }
            return end;
        };
        for (std::size_t layer = 0; layer < order.size(); layer = endOf(layer, 2))
        {
            const std::size_t layerEnd = endOf(layer, 2);
            const int firstZ = bricks_.place(order[layer])[2] * kSide;
            for (int z = std::max(low[2], firstZ); z <= std::min(high[2], firstZ + kSide - 1); ++z)
            {
                for (std::size_t row = layer; row < layerEnd;)
                {
                    const std::size_t rowEnd = std::min(layerEnd, endOf(row, 1));
                    const int firstY = bricks_.place(order[row])[1] * kSide;
                    const int lastY = std::min(high[1], firstY + kSide - 1);
                    for (int y = std::max(low[1], firstY); y <= lastY; ++y)
                    {
                        for (std::size_t k = row; k < rowEnd; ++k)
                        {
                            visitRowOf(order[k], {low[0], y, z}, high[0], visit);
                        }
                    }
                    row = rowEnd;
                }
            }
        }
    }
    template <class Visit>
    void visitRowOf(std::uint32_t brick, const GridPlace& low, int highX, Visit& visit) const
    {
        const int firstX = bricks_.place(brick)[0] * Length;
        for (int x = std::max(low[0], firstX); x <= std::min(highX, firstX + Length - 1); ++x)
        {
            visit(brick * kInBrick + inBrick(x, low[1], low[2]));
        }
    }
    /// Bricks that a range meets, by z, y and x.
    [[nodiscard]] std::vector<std::uint32_t> bricksIn(const GridPlace& low,
                                                      const GridPlace& high) const
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t brick = 0; brick < bricks_.size(); ++brick)
        {
            const auto [x, y, z] = firstCell(brick);
            if (x <= high[0] && x + Length > low[0] && y <= high[1] && y + kSide > low[1] &&
                z <= high[2] && z + kSide > low[2])
            {
                order.push_back(brick);
            }
        }
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b)
                  {
                      const GridPlace& p = bricks_.place(a);
                      const GridPlace& q = bricks_.place(b);
                      return std::tie(p[2], p[1], p[0]) < std::tie(q[2], q[1], q[0]);
                  });
        return order;
    }

    GridPlace count_;
    bool isOne_;
    BrickTable bricks_;
};

} // namespace frostfill
