// SPDX-License-Identifier: MIT
#pragma once

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
/// are listed; the surface's tree knows all. Cells are stored in blocks. Most blocks of a fine grid
/// are away from the surface; such a block takes four bytes.
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
        const std::uint32_t block = blockOf(x, y, z);
        if (block == kNoTriangles)
        {
            return {};
        }
        const std::uint32_t* start = starts_.data() + cellIndex(block, x, y, z);
        return {ids_.data() + start[0], start[1] - start[0]};
    }
    [[nodiscard]] const GridFrame& frame() const { return frame_; }
    [[nodiscard]] double reach() const { return reach_; }

    // Cells are kept in blocks of kSide cells a side. A block without triangles is one entry.
    static constexpr int kSide = 4; // cells
    static constexpr std::size_t kInBlock = std::size_t{kSide} * kSide * kSide;
    static constexpr std::uint32_t kNoTriangles = 0xffffffff;

    /// Calls visit(x, y, z) for each cell with triangles, with x fastest.
    template <class Visit>
    void forEachCellWithTriangles(Visit&& visit) const
    {
        for (int z = 0; z < frame_.count[2]; ++z)
        {
            for (int y = 0; y < frame_.count[1]; ++y)
            {
                for (int x = 0; x < frame_.count[0]; ++x)
                {
                    if (blockOf(x, y, z) == kNoTriangles)
                    {
                        x += kSide - 1 - x % kSide;
                    }
                    else if (!cell(x, y, z).empty())
                    {
                        visit(x, y, z);
                    }
                }
            }
        }
    }

    [[nodiscard]] const GridFrame& blocksFrame() const { return blocksFrame_; }
    /// Number of the cell's block among all.
    [[nodiscard]] std::size_t blockIndex(int x, int y, int z) const
    {
        return blocksFrame_.index(x / kSide, y / kSide, z / kSide);
    }
    /// Number of the cell's block among those with triangles, or kNoTriangles.
    [[nodiscard]] std::uint32_t blockOf(int x, int y, int z) const
    {
        return blocks_[blockIndex(x, y, z)];
    }
    /// Number of a cell among those of all blocks with triangles, of which it has one.
    [[nodiscard]] static std::size_t cellIndex(std::uint32_t block, int x, int y, int z)
    {
        return block * kInBlock + inBlock(x, y, z);
    }
    [[nodiscard]] std::size_t blocksWithTriangles() const { return starts_.size() / kInBlock; }
    /// Number of a cell among those of its block.
    [[nodiscard]] static std::size_t inBlock(int x, int y, int z)
    {
        const int index = (z % kSide * kSide + y % kSide) * kSide + x % kSide;
        return static_cast<std::size_t>(index);
    }

private:
    class Builder;

    const Surface* surface_;
    GridFrame frame_;
    double reach_;
    GridFrame blocksFrame_;             ///< of the blocks
    std::vector<std::uint32_t> blocks_; ///< [#blocks] index among the blocks with triangles
    std::vector<std::uint32_t> starts_; ///< [#cells of blocks with triangles + 1]
    std::vector<std::uint32_t> ids_;
};

} // namespace frostfill
