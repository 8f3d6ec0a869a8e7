// SPDX-License-Identifier: MIT
#pragma once

#include <geometry/grid_frame.hpp>
#include <mesh/surface.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// For each cell of a grid, the triangles that come within `reach` of some point of the cell. A
/// cell may hold any number of them. Cells away from the surface are empty and cost nothing.
class TriangleGrid
{
public:
    TriangleGrid(const Surface& surface, const GridFrame& frame, double reach);

    /// Triangles, ascending, among them all that are nearer to `p` than the reach. `p` lies within
    /// the frame; for points outside it the answer is that of the nearest cell.
    [[nodiscard]] std::span<const std::uint32_t> near(const Eigen::Vector3d& p) const
    {
        return cell(frame_.index(p));
    }
    [[nodiscard]] std::span<const std::uint32_t> cell(std::size_t index) const
    {
        return {ids_.data() + start_[index], start_[index + 1] - start_[index]};
    }
    [[nodiscard]] const GridFrame& frame() const { return frame_; }
    [[nodiscard]] double reach() const { return reach_; }

private:
    GridFrame frame_;
    double reach_;
    std::vector<std::uint32_t> start_; ///< [#cells + 1]
    std::vector<std::uint32_t> ids_;
};

/// Calls visit(x, y, z) for each cell of the frame that the triangle may come within `reach` of.
template <class Visit>
void forEachCellNear(const GridFrame& frame, const SurfaceTriangle& triangle, double reach,
                     Visit&& visit)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : triangle.corner)
    {
        box.extend(corner);
    }
    const auto low = frame.coordinates(box.min().array() - reach);
    const auto high = frame.coordinates(box.max().array() + reach);
    // Half a cell's diagonal: how far the cell's points are from its centre.
    const double radius = 0.8660254037844387 * frame.cell + reach;
    for (int z = low[2]; z <= high[2]; ++z)
    {
        for (int y = low[1]; y <= high[1]; ++y)
        {
            for (int x = low[0]; x <= high[0]; ++x)
            {
                const Eigen::Vector3d centre = frame.centre(x, y, z);
                if (std::abs(triangle.normal.dot(centre) - triangle.offset) > radius)
                {
                    continue;
                }
                const Eigen::Vector3d closest =
                    closestPointOnTriangle(centre, triangle.corner[0], triangle.corner[1],
                                           triangle.corner[2])
                        .point;
                if ((centre - closest).squaredNorm() <= radius * radius)
                {
                    visit(x, y, z);
                }
            }
        }
    }
}

} // namespace frostfill
