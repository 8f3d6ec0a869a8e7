// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/surface.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// The triangles within `reach` of some point of each cell of a grid. Of a cell that has many some
/// are listed; the surface's tree knows all. Memory follows the surface, not the box around it.
class TriangleGrid
{
public:
    /// Of a cell, above which the tree is quicker. Smaller: the built-in human takes 1 % more
    /// instructions at 48. Larger: scans take longer. [triangles]
    static constexpr std::size_t kShortList = 96;

    /// `surface` must outlive this object.
    TriangleGrid(const Surface& surface, const GridFrame& frame, double reach);

    /// Ascending triangles, including all that are closer to `p` than the reach, unless they are
    /// more than kShortList. `p` lies within the frame; a point outside gets those of the nearest
    /// cell.
    [[nodiscard]] std::span<const std::uint32_t> near(const Eigen::Vector3d& p) const
    {
        const auto c = frame_.coordinates(p);
        return cell(c[0], c[1], c[2]);
    }
    /// Ascending triangles, including all within `distance` of `p`, which is at most the reach.
    /// Where a cell has many, as in scans, the surface's tree finds fewer; they are put into
    /// `found`.
    [[nodiscard]] std::span<const std::uint32_t> near(const Eigen::Vector3d& p, double distance,
                                                      std::vector<std::uint32_t>& found) const
    {
        const std::span<const std::uint32_t> all = near(p);
        if (all.size() <= kShortList)
        {
            return all;
        }
        surface_->tree().findNear(p, distance, found);
        return found;
    }
    /// As nearestDistance of `all`, which is near(p) and not empty; where that is within the reach
    /// and at most `distance`.
    [[nodiscard]] SignedDistance
    nearest(const Eigen::Vector3d& p, std::span<const std::uint32_t> all,
            double distance = std::numeric_limits<double>::infinity()) const
    {
        return all.size() <= kShortList ? nearestDistance(*surface_, all, p, distance)
                                        : nearestDistance(*surface_, p, std::min(reach_, distance));
    }
    [[nodiscard]] std::span<const std::uint32_t> cell(int x, int y, int z) const
    {
        const std::size_t number = cells_.find(x, y, z);
        return number == Cells::kNone ? std::span<const std::uint32_t>{} : lists_[number];
    }
    [[nodiscard]] const GridFrame& frame() const { return frame_; }
    [[nodiscard]] double reach() const { return reach_; }
    /// A cell has the triangles that are this near to its centre: all that are within the reach of
    /// a point of it.
    [[nodiscard]] double reachOfCentre() const { return kHalfDiagonal * frame_.cell + reach_; }

    using Cells = BrickedCells<>;
    /// Bricks with triangles, never one for all: most of a grid is away from the surface.
    [[nodiscard]] const Cells& cells() const { return cells_; }

private:
    const Surface* surface_;
    GridFrame frame_;
    double reach_;
    Cells cells_;
    Buckets<std::uint32_t> lists_; ///< of triangles, by cell
};

} // namespace frostfill
