// SPDX-License-Identifier: MIT
#pragma once

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
    [[nodiscard]] bool isInBox(const GridPlace& place) const
    {
        return place[0] >= 0 && place[0] < count_[0] && place[1] >= 0 && place[1] < count_[1] &&
               place[2] >= 0 && place[2] < count_[2];
    }

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

} // namespace frostfill
