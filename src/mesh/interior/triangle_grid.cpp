// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_grid.hpp"

#include "mesh/interior/triangle_groups.hpp"

#include <algorithm>
#include <numeric>

namespace frostfill
{

/// Lists triangles in cells. A list that is long already does not grow, so what a dense patch costs
/// follows the cells, not its triangles.
class TriangleGrid::Builder
{
public:
    Builder(TriangleGrid& grid, const Surface& surface)
        : grid_(grid), surface_(surface), radius_(grid.reachOfCentre())
    {
    }

    void build()
    {
        forEachGroup(surface_, grid_.frame_.cell,
                     [&](const TriangleGroup& group)
                     {
                         enterIn(group, {coordinates(group.box.min().array() - grid_.reach_),
                                         coordinates(group.box.max().array() + grid_.reach_)});
                     });
        sort();
    }

private:
    /// Of a range along each axis, up to which it is not halved.
    static constexpr int kFewCells = 8;
    struct Entry
    {
        std::uint32_t cell;
        std::uint32_t triangle;
    };

    [[nodiscard]] GridPlace coordinates(const Eigen::Vector3d& p) const
    {
        return grid_.frame_.coordinates(p);
    }

    /// Cells from `low` to `high`, both included.
    struct Range
    {
        GridPlace low;
        GridPlace high;
    };
    /// Enters those of a group in each cell of a range that they are near. A large range is halved,
    /// and a half that the triangle is not near is left out: the box of a long triangle has far
    /// more cells than are near it.
    void enterIn(const TriangleGroup& group, const Range& range)
    {
        const Eigen::Array3i cells =
            Eigen::Array3i::Map(range.high.data()) - Eigen::Array3i::Map(range.low.data()) + 1;
        int axis = 0;
        const int longest = cells.maxCoeff(&axis);
        if (group.triangles.size() > 1)
        {
            enterInFew(group, range);
            return;
        }
        if (longest <= kFewCells)
        {
            enterInFew(group.triangles[0], range);
            return;
        }
        Range lower = range;
        Range upper = range;
        lower.high[axis] = range.low[axis] + longest / 2 - 1;
        upper.low[axis] = lower.high[axis] + 1;
        for (const Range& half : {lower, upper})
        {
            const Eigen::Array3d from = Eigen::Array3i::Map(half.low.data()).cast<double>();
            const Eigen::Array3d to = Eigen::Array3i::Map(half.high.data()).cast<double>() + 1;
            const Eigen::Vector3d middle =
                grid_.frame_.origin.array() + grid_.frame_.cell * (from + to) / 2;
            // Every middle of a cell in the half is nearer to its middle than this.
            const double reach = grid_.frame_.cell * (to - from).matrix().norm() / 2 + radius_;
            if (NearTriangle(surface_, group.triangles[0], reach).contains(middle))
            {
                enterIn(group, half);
            }
        }
    }

    void enterInFew(const TriangleGroup& group, const Range& range)
    {
        const double surelyIn = (1 - kDistanceRounding) * radius_;
        forEachCell(group.box, range,
                    [&](int x, int y, int z, double farthestSquare)
                    {
                        std::size_t cell = grid_.cells_.find(x, y, z);
                        if (cell != Cells::kNone && isLong(cell))
                        {
                            return;
                        }
                        const bool all = farthestSquare <= surelyIn * surelyIn;
                        const Eigen::Vector3d centre = grid_.frame_.centre(x, y, z);
                        for (const std::uint32_t t : group.triangles)
                        {
                            if (all || NearTriangle(surface_, t, radius_).contains(centre))
                            {
                                cell = cell == Cells::kNone ? obtain(x, y, z) : cell;
                                enter(cell, t);
                            }
                        }
                    });
    }

    void enterInFew(std::uint32_t triangle, const Range& range)
    {
        const NearTriangle near(surface_, triangle, radius_);
        const GridFrame& frame = grid_.frame_;
        const auto cellsIn = [&](const NearTriangle::Chord& chord)
        { return frame.centresWithin(0, chord.from, chord.to); };
        const auto& [low, high] = range;
        for (int z = low[2]; z <= high[2]; ++z)
        {
            for (int y = low[1]; y <= high[1]; ++y)
            {
                const Eigen::Vector3d start = frame.centre(0, y, z);
                const auto some = cellsIn(near.nearPlane(start.y(), start.z()));
                const auto surely = cellsIn(near.surelyNear(start.y(), start.z()));
                for (int x = std::max(low[0], some[0]); x <= std::min(high[0], some[1]); ++x)
                {
                    const bool isSure = x >= surely[0] && x <= surely[1];
                    if (isSure || near.contains(frame.centre(x, y, z)))
                    {
                        const std::size_t cell = obtain(x, y, z);
                        if (!isLong(cell))
                        {
                            enter(cell, triangle);
                        }
                    }
                }
            }
        }
    }

    [[nodiscard]] SquaresToBox layer(const Eigen::AlignedBox3d& box, int axis, int index) const
    {
        return {box, axis, grid_.frame_.origin[axis] + (index + 0.5) * grid_.frame_.cell};
    }

    /// Calls visit(x, y, z, farthest) for each cell of a range that may be near `box`, with the
    /// squared distance of its centre to the farthest point of the box.
    template <class Visit>
    void forEachCell(const Eigen::AlignedBox3d& box, const Range& range, Visit&& visit)
    {
        const double surelyOut = (1 + kDistanceRounding) * radius_;
        const auto& [low, high] = range;
        layersOfX_.clear();
        for (int x = low[0]; x <= high[0]; ++x)
        {
            layersOfX_.push_back(layer(box, 0, x));
        }
        for (int z = low[2]; z <= high[2]; ++z)
        {
            const SquaresToBox atZ = layer(box, 2, z);
            for (int y = low[1]; y <= high[1]; ++y)
            {
                const SquaresToBox atY = layer(box, 1, y);
                const double left = surelyOut * surelyOut - (atZ.nearest + atY.nearest);
                for (int x = left < 0 ? high[0] + 1 : low[0]; x <= high[0]; ++x)
                {
                    const SquaresToBox& atX = layersOfX_[static_cast<std::size_t>(x - low[0])];
                    if (atX.nearest <= left)
                    {
                        visit(x, y, z, atX.farthest + (atY.farthest + atZ.farthest));
                    }
                }
            }
        }
    }

    [[nodiscard]] bool isLong(std::size_t cell) const { return grid_.starts_[cell] > kShortList; }

    std::size_t obtain(int x, int y, int z)
    {
        const std::size_t cell = grid_.cells_.obtain(x, y, z);
        if (cell >= grid_.starts_.size())
        {
            grid_.starts_.resize(grid_.cells_.size(), 0);
        }
        return cell;
    }

    void enter(std::size_t cell, std::uint32_t triangle)
    {
        ++grid_.starts_[cell];
        entries_.push_back({static_cast<std::uint32_t>(cell), triangle});
    }

    /// Sorts by the triangle, then by the cell: sums up the ends, and fills from them.
    void sort()
    {
        std::vector<std::uint32_t> ends(surface_.size() + 1);
        for (const Entry& each : entries_)
        {
            ++ends[each.triangle];
        }
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<std::uint32_t> cells(entries_.size());
        for (const Entry& each : entries_)
        {
            cells[--ends[each.triangle]] = each.cell;
        }
        std::vector<std::uint32_t>& starts = grid_.starts_;
        starts.push_back(0);
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        grid_.ids_.resize(cells.size());
        for (std::size_t t = surface_.size(); t-- > 0;)
        {
            for (std::uint32_t k = ends[t]; k < ends[t + 1]; ++k)
            {
                grid_.ids_[--starts[cells[k]]] = static_cast<std::uint32_t>(t);
            }
        }
    }

    TriangleGrid& grid_;
    const Surface& surface_;
    double radius_;
    std::vector<Entry> entries_;
    std::vector<SquaresToBox> layersOfX_; ///< of the box that cells are looked up for
};

TriangleGrid::TriangleGrid(const Surface& surface, const GridFrame& frame, double reach)
    : surface_(&surface), frame_(frame), reach_(reach), cells_(frame.count, 0)
{
    Builder(*this, surface).build();
}

} // namespace frostfill
