// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "mesh/interior/winding_columns.hpp"

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
    /// The same where the nearest triangle of p's cell is known, which has some.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p, const SignedDistance& nearest) const;

    /// The same by the winding number alone, of a point that is not on the surface: right even near
    /// triangles of which some face the wrong way.
    [[nodiscard]] bool isInsideByWinding(const Eigen::Vector3d& p) const
    {
        return winding_.at(p) > kInsideFrom;
    }

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

    /// Calls visit(box) for boxes that hold all that is inside or within reach of the surface.
    template <class Visit>
    void forEachBoxInReach(Visit&& visit) const
    {
        const BrickTable& near = grid_->cells().bricks();
        for (std::size_t brick = 0; brick < near.size(); ++brick)
        {
            if (const Eigen::AlignedBox3d box = boxInReach(brick); !box.isEmpty())
            {
                visit(box);
            }
        }
        for (std::size_t brick = 0; brick < far_.size(); ++brick)
        {
            if (farSide_[brick] == Side::inside)
            {
                visit(boxOf(far_.place(brick)));
            }
        }
    }
    [[nodiscard]] const TriangleGrid& grid() const { return *grid_; }

    [[nodiscard]] double reach() const { return grid_->reach(); }

private:
    [[nodiscard]] bool isNearTwoSided(const Eigen::Vector3d& p) const;
    [[nodiscard]] bool isInsideFarFromSurface(const Eigen::Vector3d& p) const;
    using Cell = GridPlace;
    enum class Side : std::uint8_t
    {
        unknown,
        inside,
        outside
    };
    class Flood;
    [[nodiscard]] bool isCellInside(const Cell& cell) const;
    /// Of a brick without triangles, by its number in far_; kNone of one that is outside.
    [[nodiscard]] std::uint32_t farBrick(const Cell& cell) const;
    [[nodiscard]] Side& sideOfBrick(const GridPlace& brick);
    /// About the cells of a brick with triangles that are inside or have triangles.
    [[nodiscard]] Eigen::AlignedBox3d boxInReach(std::size_t brick) const;
    [[nodiscard]] Eigen::AlignedBox3d boxOf(const GridPlace& brick) const
    {
        const GridFrame& frame = grid_->frame();
        const double edge = frame.cell * TriangleGrid::Cells::kSide;
        const Eigen::Vector3d low =
            frame.origin + edge * Eigen::Vector3d(brick[0], brick[1], brick[2]);
        return {low, low.array() + edge};
    }

    const Surface* surface_;
    const TriangleGrid* grid_;
    WindingColumns winding_;
    // Sides of what has no triangles: of bricks, and of cells in bricks with triangles.
    BrickTable far_;               ///< bricks inside, and those beside the surface
    std::vector<Side> farSide_;    ///< [#far_]
    std::vector<bool> cellInside_; ///< [#cells of the grid]
};

} // namespace frostfill
