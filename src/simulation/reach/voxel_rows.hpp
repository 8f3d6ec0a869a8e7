// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/reach/voxel_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

/// Which cubes lie in a ball or near one, row by row.
namespace frostfill
{

/// Cubes first..last of a row; none when last < first.
struct VoxelRun
{
    int first;
    int last;
};

/// A row, by its place across x. Searches take rows from the top down, and of one height by z.
struct VoxelRow
{
    int y = std::numeric_limits<int>::max(); ///< unless told, above all
    int z = std::numeric_limits<int>::min();

    [[nodiscard]] bool isBefore(const VoxelRow& other) const
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
    [[nodiscard]] std::uint64_t numberFrom(VoxelRow row) const
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

/// Which cubes of a grid belong to a ball, by what is added to the distance of their middle along
/// each axis.
inline constexpr double kInsideBall = 0.5; ///< the farthest corner is within the radius
inline constexpr double kMeetsBall = -0.5; ///< the nearest point is
/// The cubes of a grid about a ball.
class BallRows
{
public:
    BallRows(const GridFrame& frame, const Eigen::Vector3d& centre, double radius, double half)
        : count_(frame.count), centre_(((centre - frame.origin) / frame.cell).array() - 0.5),
          radius_(radius / frame.cell), half_(half), widest_(range(0, radius_ - half)),
          window_(range(1, radius_ - half), range(2, radius_ - half))
    {
    }
    [[nodiscard]] const RowWindow& window() const { return window_; }

    /// What no row has more cubes than.
    [[nodiscard]] VoxelRun widest() const { return {widest_[0], widest_[1]}; }

    [[nodiscard]] VoxelRun run(int y, int z) const
    {
        const double dy = std::max(0.0, std::abs(y - centre_.y()) + half_);
        const double dz = std::max(0.0, std::abs(z - centre_.z()) + half_);
        const double rest = radius_ * radius_ - dy * dy - dz * dz;
        if (rest < 0)
        {
            return {0, -1};
        }
        const auto x = range(0, std::sqrt(rest) - half_);
        return {x[0], x[1]};
    }

    /// Calls visit(VoxelWord) for the cubes of all rows but those that have none in `set`: most
    /// rows that a sphere at rest meets have been closed by its neighbours.
    template <class Visit>
    void forEachWord(const VoxelLayout& layout, const VoxelBits& set, Visit&& visit) const
    {
        const VoxelRun most = widest();
        if (most.first > most.last)
        {
            return;
        }
        std::uint64_t row = 0;
        window_.find(
            row,
            [&](int y, int z)
            {
                const VoxelRun its = run(y, z);
                if (its.first <= its.last)
                {
                    layout.forEachWord(y, z, its.first, its.last, visit);
                }
                return false;
            },
            [&](int y, int z, int last)
            { return layout.firstRow(set, y, z, last, most.first, most.last); });
    }

private:
    [[nodiscard]] std::array<int, 2> range(int axis, double reach) const
    {
        return wholeNumbers(centre_[axis] - reach, centre_[axis] + reach, count_[axis]);
    }

    std::array<int, 3> count_;
    Eigen::Vector3d centre_; ///< in cubes, counted from the middle of cube 0
    double radius_;          ///< in cubes
    double half_;
    std::array<int, 2> widest_;
    RowWindow window_;
};

} // namespace frostfill
