// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/cell_rows.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/triangle_groups.hpp"

namespace frostfill
{

/// The cells of a grid whose middle is within `reach` of one of several triangles: the same as
/// TriangleRows finds for each of them. The box around them decides for most cells.
class GroupRows
{
public:
    GroupRows(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
              double reach)
        : frame_(frame), surface_(surface), group_(group), reach_(reach),
          surelyOut_((1 + kDistanceRounding) * reach), surelyIn_((1 - kDistanceRounding) * reach)
    {
    }

    /// Calls visit(y, z, run) for rows from `from` on, until it returns true, with those cells that
    /// the box may be near. Rows from the top down, as of a RowWindow.
    template <class Visit>
    void find(CellRow from, Visit&& visit) const
    {
        const auto [lowY, highY] = range(1, surelyOut_);
        const auto [lowZ, highZ] = range(2, surelyOut_);
        int z = from.y > highY ? lowZ : std::max(lowZ, from.z);
        for (int y = std::min(highY, from.y); y >= lowY; --y, z = lowZ)
        {
            const double leftOfY = surelyOut_ * surelyOut_ - squares(1, y).nearest;
            for (; z <= highZ; ++z)
            {
                const double left = leftOfY - squares(2, z).nearest;
                const auto [first, last] = range(0, std::sqrt(std::max(0.0, left)));
                if (left >= 0 && first <= last && visit(y, z, CellRun{first, last}))
                {
                    return;
                }
            }
        }
    }
    /// Calls visit(y, z, run) for all of them.
    template <class Visit>
    void forEach(Visit&& visit) const
    {
        find({},
             [&](int y, int z, CellRun run)
             {
                 visit(y, z, run);
                 return false;
             });
    }

    /// Of a cell in such a row.
    [[nodiscard]] bool near(int x, int y, int z) const
    {
        const Eigen::Vector3d middle = frame_.centre(x, y, z);
        return isNearAll(x, y, z) ||
               std::any_of(group_.triangles.begin(), group_.triangles.end(),
                           [&](std::uint32_t t)
                           { return NearTriangle(surface_, t, reach_).contains(middle); });
    }
    /// Which of some triangles, a bit for each by its number in the group, it is near.
    [[nodiscard]] std::uint64_t nearAmong(std::uint64_t some, int x, int y, int z) const
    {
        if (isNearAll(x, y, z))
        {
            return some;
        }
        const Eigen::Vector3d middle = frame_.centre(x, y, z);
        std::uint64_t near = 0;
        for (; some != 0; some &= some - 1)
        {
            const auto k = static_cast<std::size_t>(std::countr_zero(some));
            const bool its = NearTriangle(surface_, group_.triangles[k], reach_).contains(middle);
            near |= std::uint64_t{its ? 1U : 0U} << k;
        }
        return near;
    }

private:
    [[nodiscard]] bool isNearAll(int x, int y, int z) const
    {
        const double farthest =
            squares(0, x).farthest + (squares(1, y).farthest + squares(2, z).farthest);
        return farthest <= surelyIn_ * surelyIn_;
    }
    [[nodiscard]] SquaresToBox squares(int axis, int cube) const
    {
        return {group_.box, axis, frame_.origin[axis] + (cube + 0.5) * frame_.cell};
    }
    /// Cubes up to so far from the box along an axis.
    [[nodiscard]] std::array<int, 2> range(int axis, double far) const
    {
        const double from = frame_.origin[axis] + 0.5 * frame_.cell;
        return wholeNumbers((group_.box.min()[axis] - far - from) / frame_.cell - kFilterRounding,
                            (group_.box.max()[axis] + far - from) / frame_.cell + kFilterRounding,
                            frame_.count[axis]);
    }

    const GridFrame& frame_;
    const Surface& surface_;
    const TriangleGroup& group_;
    double reach_;
    double surelyOut_;
    double surelyIn_;
};

} // namespace frostfill
