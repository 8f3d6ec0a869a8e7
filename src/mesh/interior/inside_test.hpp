// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "mesh/interior/winding_columns.hpp"
#include "mesh/interior/winding_number.hpp"

#include <array>
#include <limits>
#include <vector>

namespace frostfill
{

/// Whether a point is inside a closed surface: where the winding number is above kInsideFrom. Takes
/// constant time for a surface that does not cross itself: cells without triangles are classified
/// once, and near the surface the sign of the nearest triangle decides. Near a two-sided triangle
/// the winding number itself does.
class InsideTest
{
public:
    /// Both arguments must outlive this object. The frame of the grid encloses the surface with a
    /// margin of at least one cell.
    InsideTest(const Surface& surface, const TriangleGrid& grid);

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;

    /// Distance to the surface, positive inside, clamped to +- the reach of the grid. Sooner where
    /// it is known to be at most so much on either side.
    [[nodiscard]] double distance(const Eigen::Vector3d& p,
                                  double atMost = std::numeric_limits<double>::infinity()) const;

    /// Whether p is outside and in a cell without triangles: a look at a table.
    [[nodiscard]] bool isFarOutside(const Eigen::Vector3d& p) const
    {
        const auto [x, y, z] = grid_->frame().coordinates(p);
        return grid_->cell(x, y, z).empty() && !isCellInside({x, y, z});
    }

    /// x coordinate up to which all points of p's row, from p on, are surely outside and beyond the
    /// reach of the grid; that of p if nothing is known. p lies within the frame.
    [[nodiscard]] double farOutsideUntil(const Eigen::Vector3d& p) const;

    [[nodiscard]] double reach() const { return grid_->reach(); }

private:
    [[nodiscard]] bool isNearTwoSided(const Eigen::Vector3d& p) const;
    [[nodiscard]] bool isInsideFarFromSurface(const Eigen::Vector3d& p) const;
    using Cell = std::array<int, 3>;
    class Flood;
    [[nodiscard]] bool isCellInside(const Cell& cell) const;
    [[nodiscard]] bool isInsideByWinding(const Eigen::Vector3d& p) const
    {
        return winding_.at(p) > kInsideFrom;
    }

    const Surface* surface_;
    const TriangleGrid* grid_;
    WindingColumns winding_;
    // Sides of what has no triangles: of blocks, and of cells in blocks with triangles.
    std::vector<bool> blockInside_; ///< [#blocks]
    std::vector<bool> cellInside_;  ///< [#blocks with triangles x cells of a block]
};

} // namespace frostfill
