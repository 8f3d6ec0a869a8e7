// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

/// Cells of a grid, row by row along x.
namespace frostfill
{

/// Widens a filter before the exact test: what a row is asked for. [cells] Smaller: rounding hides
/// a cell. Larger: cells are tested in vain.
inline constexpr double kFilterRounding = 1e-6;

/// Cells first..last of a row; none when last < first.
struct CellRun
{
    int first;
    int last;
};

/// A row, by its place across x. Searches take rows from the top down, and of one height by z.
struct CellRow
{
    int y = std::numeric_limits<int>::max(); ///< unless told, above all
    int z = std::numeric_limits<int>::min();

    [[nodiscard]] bool isBefore(const CellRow& other) const
    {
        return y != other.y ? y > other.y : z < other.z;
    }
};

/// Of rows that a search may leave out: none.
struct EveryRow
{
    template <class... Window>
    int operator()(int, int z, int, const Window&...) const
    {
        return z;
    }
};

/// A window of rows, numbered from the top down. Holes in a pile close from below, so the topmost
/// reached cube near an obstacle is the last to go: a search that starts there resumes least.
class RowWindow
{
public:
    RowWindow(std::array<int, 2> y, std::array<int, 2> z)
        : top_(y[1]), firstZ_(z[0]), depth_(z[1] - z[0] + 1),
          count_(y[1] < y[0] || depth_ < 1
                     ? 0
                     : static_cast<std::uint64_t>(y[1] - y[0] + 1) * static_cast<unsigned>(depth_))
    {
    }
    /// Rows.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] int y(std::uint64_t row) const
    {
        return top_ - static_cast<int>(row / static_cast<unsigned>(depth_));
    }
    [[nodiscard]] int z(std::uint64_t row) const
    {
        return firstZ_ + static_cast<int>(row % static_cast<unsigned>(depth_));
    }
    [[nodiscard]] std::uint64_t number(int y, int z) const
    {
        return static_cast<std::uint64_t>(top_ - y) * static_cast<unsigned>(depth_) +
               static_cast<unsigned>(z - firstZ_);
    }
    /// The number of a row, or of the next one in the window.
    [[nodiscard]] std::uint64_t numberFrom(CellRow row) const
    {
        if (row.y > top_ || count_ == 0)
        {
            return 0;
        }
        const int lastZ = firstZ_ + depth_ - 1;
        return row.z > lastZ ? number(row.y - 1, firstZ_) : number(row.y, std::max(row.z, firstZ_));
    }
    /// Looks for a row from number `row` on for which test(y, z) holds. Leaves its number in `row`,
    /// or the number of rows when there is none. Asks only rows next(y, z, last): the first from z
    /// to `last` that is worth it, or last + 1.
    template <class Test, class Next = EveryRow>
    bool find(std::uint64_t& row, Test&& test, Next&& next = {}) const
    {
        if (row >= count_)
        {
            return false;
        }
        const int last = firstZ_ + depth_ - 1;
        int z = this->z(row);
        for (int y = this->y(row); row < count_; --y, z = firstZ_)
        {
            for (; z <= last; ++z, ++row)
            {
                const int worth = next(y, z, last);
                row += static_cast<unsigned>(worth - z);
                z = worth;
                if (z > last)
                {
                    break;
                }
                if (test(y, z))
                {
                    return true;
                }
            }
        }
        return false;
    }

    template <class Visit>
    void forEach(Visit&& visit) const
    {
        std::uint64_t row = 0;
        find(row,
             [&](int y, int z)
             {
                 visit(y, z);
                 return false;
             });
    }

private:
    int top_;
    int firstZ_;
    int depth_;
    std::uint64_t count_;
};

/// Calls visit(word, bits) for the words of a row, 64 cells each, that have cells of a run: bit i
/// of word w is cell 64 w + i.
template <class Visit>
void forEachWordOf(CellRun run, Visit&& visit)
{
    for (int word = run.first / 64; run.first <= run.last && word <= run.last / 64; ++word)
    {
        std::uint64_t bits = ~std::uint64_t{0};
        bits &= word == run.first / 64 ? ~std::uint64_t{0} << run.first % 64 : bits;
        bits &= word == run.last / 64 ? ~std::uint64_t{0} >> (63 - run.last % 64) : bits;
        visit(word, bits);
    }
}

} // namespace frostfill
