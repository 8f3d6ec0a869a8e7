// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_groups.hpp"
#include "simulation/reach/voxel_rows.hpp"

namespace frostfill
{

/// The cubes of a grid whose middle is within `reach` of one of several triangles: the same as
/// TriangleRows finds for each of them. The box around them decides for most cubes.
class GroupRows
{
public:
    GroupRows(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
              double reach)
        : frame_(frame), surface_(surface), group_(group), reach_(reach),
          surelyOut_((1 + kDistanceRounding) * reach), surelyIn_((1 - kDistanceRounding) * reach)
    {
    }

    /// Calls visit(y, z, run) for each row with those cubes that the box may be near.
    template <class Visit>
    void forEach(Visit&& visit) const
    {
        const auto [lowY, highY] = range(1, surelyOut_);
        const auto [lowZ, highZ] = range(2, surelyOut_);
        for (int y = lowY; y <= highY; ++y)
        {
            const double leftOfY = surelyOut_ * surelyOut_ - squares(1, y).nearest;
            for (int z = lowZ; z <= highZ; ++z)
            {
                const double left = leftOfY - squares(2, z).nearest;
                const auto [first, last] = range(0, std::sqrt(std::max(0.0, left)));
                if (left >= 0 && first <= last)
                {
                    visit(y, z, VoxelRun{first, last});
                }
            }
        }
    }

    /// Of a cube in such a row.
    [[nodiscard]] bool near(int x, int y, int z) const
    {
        const double farthest =
            squares(0, x).farthest + (squares(1, y).farthest + squares(2, z).farthest);
        const Eigen::Vector3d middle = frame_.centre(x, y, z);
        return farthest <= surelyIn_ * surelyIn_ ||
               std::any_of(group_.triangles.begin(), group_.triangles.end(),
                           [&](std::uint32_t t) { return isWithin(surface_, t, middle, reach_); });
    }

private:
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
