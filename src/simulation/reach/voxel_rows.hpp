// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/cell_rows.hpp"
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
    [[nodiscard]] CellRun widest() const { return {widest_[0], widest_[1]}; }

    [[nodiscard]] CellRun run(int y, int z) const
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
        const CellRun most = widest();
        if (most.first > most.last)
        {
            return;
        }
        std::uint64_t row = 0;
        window_.find(
            row,
            [&](int y, int z)
            {
                const CellRun its = run(y, z);
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
