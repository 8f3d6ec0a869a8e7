// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "mesh/interior/winding_columns.hpp"

#include <cmath>
#include <limits>

namespace frostfill
{

/// Whether a point is inside a closed surface: where the winding number is above kInsideFrom. Near
/// the surface the sign of the nearest triangle decides, and takes no longer than its distance.
/// Elsewhere, and near a two-sided triangle, the winding number itself does.
class InsideTest
{
public:
    /// Both arguments must outlive this object. The frame of the grid encloses the surface with a
    /// margin of at least one cell.
    InsideTest(const Surface& surface, const TriangleGrid& grid)
        : surface_(&surface), grid_(&grid), winding_(surface.mesh())
    {
    }

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const { return distance(p) > 0; }
    /// The same where the nearest triangle of p's cell is known, which has some.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p, const SignedDistance& nearest) const
    {
        return std::abs(nearest.value) > reach() || isNearTwoSided(p) ? isInsideByWinding(p)
                                                                      : nearest.value > 0;
    }

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

    /// Whether p is outside and in a cell without triangles.
    [[nodiscard]] bool isFarOutside(const Eigen::Vector3d& p) const
    {
        return grid_->near(p).empty() && !isInsideByWinding(p);
    }

    /// Calls visit(box) for boxes that hold all that is inside or within reach of the surface:
    /// bricks of cells with triangles, and those inside. Its cost follows the bricks of one side of
    /// the box around the object.
    template <class Visit>
    void forEachBoxInReach(Visit&& visit) const
    {
        const BrickTable& near = grid_->cells().bricks();
        for (std::size_t brick = 0; brick < near.size(); ++brick)
        {
            visit(boxOf(near.place(brick)));
        }
        const int along = winding_.along();
        const int u = (along + 1) % 3;
        const int v = (along + 2) % 3;
        GridPlace brick{};
        for (brick[v] = 0; brick[v] < near.count()[v]; ++brick[v])
        {
            for (brick[u] = 0; brick[u] < near.count()[u]; ++brick[u])
            {
                brick[along] = 0;
                for (const auto& [low, high] : winding_.stretchesInside(boxOf(brick).center()))
                {
                    // Those whose middle is in it: without triangles, all of a brick is inside.
                    for (; brick[along] < near.count()[along]; ++brick[along])
                    {
                        const double middle = boxOf(brick).center()[along];
                        if (middle >= high)
                        {
                            break;
                        }
                        if (middle > low &&
                            near.find(brick[0], brick[1], brick[2]) == BrickTable::kNone)
                        {
                            visit(boxOf(brick));
                        }
                    }
                }
            }
        }
    }
    [[nodiscard]] const TriangleGrid& grid() const { return *grid_; }

    [[nodiscard]] double reach() const { return grid_->reach(); }

private:
    [[nodiscard]] bool isNearTwoSided(const Eigen::Vector3d& p) const;
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
};

} // namespace frostfill
