// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

/// Which cells of a grid are near a surface.
namespace frostfill
{

/// By which a distance may be wrong, a thousandfold. [1]
inline constexpr double kDistanceRounding = 1e-9;

/// Triangles that lie side by side, or one.
struct TriangleGroup
{
    std::span<const std::uint32_t> triangles;
    Eigen::AlignedBox3d box; ///< around them
};

[[nodiscard]] inline TriangleGroup groupOf(const Surface& surface,
                                           std::span<const std::uint32_t> triangles)
{
    TriangleGroup group{triangles, {}};
    for (const std::uint32_t t : triangles)
    {
        const auto& [a, b, c] = surface[t].corner;
        group.box.extend(a).extend(b).extend(c);
    }
    return group;
}

/// Calls visit(group) for some triangles of a surface, in their order. Those that are small ask
/// together what they are near: a group is no longer than `longest`, unless it is one triangle.
/// Larger: more of what is asked for a group has to be asked for each of its triangles.
template <class Visit>
void forEachGroup(const Surface& surface, std::span<const std::uint32_t> triangles, double longest,
                  Visit&& visit)
{
    const TriangleGroup group = groupOf(surface, triangles);
    if (triangles.size() == 1 || group.box.sizes().maxCoeff() <= longest)
    {
        visit(group);
        return;
    }
    forEachGroup(surface, triangles.first(triangles.size() / 2), longest, visit);
    forEachGroup(surface, triangles.subspan(triangles.size() / 2), longest, visit);
}
/// The same for all triangles, in the order of the surface's tree, on several threads.
template <class Visit>
void forEachGroup(const Surface& surface, double longest, Threads& threads, Visit&& visit)
{
    constexpr std::size_t kTogether = 16; // in the tree, among which groups are looked for
    const std::span<const std::uint32_t> order = surface.tree().order();
    threads.forEach((order.size() + kTogether - 1) / kTogether,
                    [&](std::size_t part)
                    {
                        const auto left = order.subspan(part * kTogether);
                        forEachGroup(surface, left.first(std::min(kTogether, left.size())), longest,
                                     visit);
                    });
}
/// The same on one.
template <class Visit>
void forEachGroup(const Surface& surface, double longest, Visit&& visit)
{
    Threads one(1);
    forEachGroup(surface, longest, one, visit);
}

/// Whether points are within `reach` of a group of triangles. Its box decides of most, and the
/// triangles' planes; the nearest of their points is looked for where those do not.
class NearGroup
{
public:
    NearGroup(const Surface& surface, const TriangleGroup& group, double reach)
        : surface_(surface), group_(group), reach_(reach),
          surelyOut_((1 + kDistanceRounding) * reach),
          surelyIn_(std::max(0.0, (1 - kDistanceRounding) * reach))
    {
    }

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const
    {
        return group_.box.squaredExteriorDistance(p) <= surelyOut_ * surelyOut_ &&
               containsNearBox(p);
    }
    /// The same of a point that is within the reach of the box.
    [[nodiscard]] bool containsNearBox(const Eigen::Vector3d& p) const
    {
        const Eigen::AlignedBox3d& box = group_.box;
        return (p - box.min()).cwiseAbs().cwiseMax((p - box.max()).cwiseAbs()).squaredNorm() <=
                   surelyIn_ * surelyIn_ ||
               std::any_of(group_.triangles.begin(), group_.triangles.end(),
                           [&](std::uint32_t t) { return isNear(t, p); });
    }
    /// Of one triangle.
    [[nodiscard]] bool isNear(std::uint32_t triangle, const Eigen::Vector3d& p) const
    {
        const TriangleBound& bound = surface_.bound(triangle);
        const auto& [a, b, c] = surface_[triangle].corner;
        return bound.toCentreSquared(p) <= surelyIn_ * surelyIn_ ||
               (bound.mayBeWithin(surelyOut_, p) &&
                (closestPointOnTriangle(p, a, b, c).point - p).squaredNorm() <= reach_ * reach_);
    }

private:
    const Surface& surface_;
    const TriangleGroup& group_;
    double reach_;
    double surelyOut_;
    double surelyIn_;
};

/// Cells of a grid, both ends included.
struct CellRange
{
    Eigen::Array3i low, high;
};
struct AnyRange
{
    bool operator()(const CellRange&) const { return true; }
};

/// Cells that may have their middle within a distance of a group of triangles: of its box, and of
/// the plane of a triangle alone.
class RowsNear
{
public:
    RowsNear(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
             double distance)
        : frame_(frame), box_(group.box), bound_(surface.bound(group.triangles[0])),
          hasPlane_(group.triangles.size() == 1 && bound_.normal.x() != 0),
          far_(distance + kFilterRounding * frame.cell)
    {
    }

    /// Around all of them.
    [[nodiscard]] CellRange all() const
    {
        CellRange all{};
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto [first, last] =
                frame_.centresWithin(axis, box_.min()[axis] - far_, box_.max()[axis] + far_);
            all.low[axis] = first;
            all.high[axis] = last;
        }
        return all;
    }
    /// Returns those of the row whose first cell has the middle `row`.
    [[nodiscard]] CellRun runIn(const CellRange& range, const Eigen::Vector3d& row) const
    {
        const double left = far_ * far_ - squareBeside(row.y(), 1) - squareBeside(row.z(), 2);
        if (left < 0)
        {
            return CellRun{0, -1};
        }
        const double along = std::sqrt(left);
        double from = box_.min().x() - along;
        double to = box_.max().x() + along;
        if (hasPlane_)
        {
            const double inPlane =
                row.x() + (bound_.offset - bound_.normal.dot(row)) / bound_.normal.x();
            const double beside = far_ / std::abs(bound_.normal.x());
            from = std::max(from, inPlane - beside);
            to = std::min(to, inPlane + beside);
        }
        const auto [first, last] = frame_.centresWithin(0, from, to);
        return CellRun{std::max(first, range.low[0]), std::min(last, range.high[0])};
    }

private:
    [[nodiscard]] double squareBeside(double p, int axis) const
    {
        const double outside = std::max({0.0, box_.min()[axis] - p, p - box_.max()[axis]});
        return outside * outside;
    }

    const GridFrame& frame_;
    const Eigen::AlignedBox3d& box_;
    const TriangleBound& bound_;
    bool hasPlane_;
    double far_;
};

/// Finds the cells of a grid whose middle is within `distance` of a group of triangles. Calls
/// visit(y, z, run, isNear) for rows with a run of cells that may be, of which isNear(x) tells; a
/// row may come in several runs. Leaves out ranges that are not worth it, of those that are not
/// halved any more.
template <class Visit, class IsWorthIt = AnyRange>
void forEachRunNear(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
                    double distance, Visit&& visit, IsWorthIt&& isWorthIt = {})
{
    constexpr int kFewCells = 10; // along an axis, up to which a range is not halved
    const NearGroup near(surface, group, distance);
    const RowsNear rows(frame, surface, group, distance);
    const auto visitRows = [&](const CellRange& range)
    {
        for (int y = range.low[1]; y <= range.high[1]; ++y)
        {
            for (int z = range.low[2]; z <= range.high[2]; ++z)
            {
                const CellRun run = rows.runIn(range, frame.centre(0, y, z));
                if (run.first <= run.last)
                {
                    visit(y, z, run,
                          [&](int x) { return near.containsNearBox(frame.centre(x, y, z)); });
                }
            }
        }
    };
    // A half that the triangle is not near is left out: the box of a long triangle has far more
    // cells than are near it.
    const auto visitHalves = [&](auto&& self, const CellRange& range) -> void
    {
        int axis = 0;
        const int longest = (range.high - range.low + 1).maxCoeff(&axis);
        if (group.triangles.size() > 1 || longest <= kFewCells)
        {
            if (isWorthIt(range))
            {
                visitRows(range);
            }
            return;
        }
        CellRange lower = range;
        CellRange upper = range;
        lower.high[axis] = range.low[axis] + longest / 2 - 1;
        upper.low[axis] = lower.high[axis] + 1;
        for (const CellRange& half : {lower, upper})
        {
            // Every middle of a cell in the half is nearer to its middle than this.
            const Eigen::Vector3d sides = frame.cell * (half.high - half.low + 1).cast<double>();
            const Eigen::Vector3d middle =
                frame.origin + frame.cell * half.low.cast<double>().matrix() + sides / 2;
            if (NearGroup(surface, group, distance + sides.norm() / 2).contains(middle))
            {
                self(self, half);
            }
        }
    };
    const CellRange all = rows.all();
    if (distance >= 0 && (all.low <= all.high).all())
    {
        visitHalves(visitHalves, all);
    }
}

} // namespace frostfill
