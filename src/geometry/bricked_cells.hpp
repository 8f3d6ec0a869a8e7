// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Three whole numbers: a cell of a grid, or a brick of cells.
using GridPlace = std::array<int, 3>;

/// Numbers the bricks of a box that are in use, from 0 in the order in which they were asked for.
/// A small box has a table of all its bricks. A large one has a hash table of those in use, so that
/// memory follows them and not the box.
class BrickTable
{
public:
    static constexpr std::uint32_t kNone = 0xffffffff;
    /// Bricks up to which a box has a table of all, four bytes each. Larger: memory for bricks
    /// without anything. Smaller: searches in ordinary objects take a hash.
    static constexpr std::size_t kSmallBox = std::size_t{1} << 21;

    explicit BrickTable(const GridPlace& count, std::size_t smallBox = kSmallBox) : count_(count)
    {
        const double all = static_cast<double>(count[0]) * count[1] * count[2];
        isSmall_ = all <= static_cast<double>(smallBox);
        if (isSmall_)
        {
            all_.assign(static_cast<std::size_t>(all), kNone);
            return;
        }
        hashed_.assign(std::size_t{1} << kFirstBits, kNone);
    }

    /// kNone for a brick that is not in use. The place lies in the box.
    [[nodiscard]] std::uint32_t find(int x, int y, int z) const
    {
        return isSmall_ ? all_[indexOf(x, y, z)] : findHashed(x, y, z);
    }
    /// Takes the brick into use, unless it is already.
    std::uint32_t obtain(int x, int y, int z)
    {
        const GridPlace place = {x, y, z};
        std::uint32_t& number = isSmall_ ? all_[indexOf(x, y, z)] : hashed_[slotOf(place)];
        if (number != kNone)
        {
            return number;
        }
        const auto its = static_cast<std::uint32_t>(places_.size());
        number = its;
        places_.push_back(place);
        if (!isSmall_ && 2 * places_.size() > hashed_.size())
        {
            grow();
        }
        return its;
    }

    /// Bricks in use.
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] const GridPlace& place(std::size_t number) const { return places_[number]; }
    /// Bricks of the box along each axis.
    [[nodiscard]] const GridPlace& count() const { return count_; }

private:
    [[nodiscard, gnu::noinline]] std::uint32_t findHashed(int x, int y, int z) const
    {
        return hashed_[slotOf({x, y, z})];
    }
    [[nodiscard]] std::size_t indexOf(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x;
    }
    /// In place of ==, which calls memcmp: 7 % of a run of 100 million spheres.
    static bool isSame(const GridPlace& a, const GridPlace& b)
    {
        return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
    /// Where the brick is in the hash table, or would be.
    [[nodiscard]] std::size_t slotOf(const GridPlace& place) const
    {
        const std::uint64_t key = (static_cast<std::uint64_t>(place[2]) << 42) ^
                                  (static_cast<std::uint64_t>(place[1]) << 21) ^
                                  static_cast<std::uint64_t>(place[0]);
        // Fibonacci hashing: the highest bits of a product with the golden ratio.
        std::size_t slot = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> (64 - bits_));
        while (hashed_[slot] != kNone && !isSame(places_[hashed_[slot]], place))
        {
            slot = (slot + 1) & (hashed_.size() - 1);
        }
        return slot;
    }
    void grow()
    {
        ++bits_;
        hashed_.assign(2 * hashed_.size(), kNone);
        for (std::uint32_t number = 0; number < places_.size(); ++number)
        {
            hashed_[slotOf(places_[number])] = number;
        }
    }

    static constexpr int kFirstBits = 6;
    GridPlace count_;
    bool isSmall_ = false;
    std::vector<std::uint32_t> all_;    ///< [#bricks of the box], of a small one
    std::vector<std::uint32_t> hashed_; ///< [2^bits_], else; at most half of it in use
    int bits_ = kFirstBits;
    std::vector<GridPlace> places_; ///< [#bricks in use]
};

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

    [[nodiscard]] bool isOne() const { return isOne_; }
    /// Those that have numbers, unless the grid is one brick.
    [[nodiscard]] const BrickTable& bricks() const { return bricks_; }
    /// Where the cell with this number lies.
    [[nodiscard]] GridPlace cell(std::size_t number) const
    {
        if (isOne_)
        {
            const std::size_t row = number / static_cast<std::size_t>(count_[0]);
            const auto rows = static_cast<std::size_t>(count_[1]);
            return {static_cast<int>(number % static_cast<std::size_t>(count_[0])),
                    static_cast<int>(row % rows), static_cast<int>(row / rows)};
        }
        const GridPlace& brick = bricks_.place(number / kInBrick);
        const auto rest = static_cast<int>(number % kInBrick);
        return {brick[0] * Length + rest % Length, brick[1] * kSide + rest / Length % kSide,
                brick[2] * kSide + rest / (Length * kSide)};
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

    GridPlace count_;
    bool isOne_;
    BrickTable bricks_;
};

} // namespace frostfill
