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

/// Whether points are within `reach` of a group of triangles. The triangles' planes and discs
/// decide of most; the nearest of their points is looked for where those do not.
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
        return std::any_of(group_.triangles.begin(), group_.triangles.end(),
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

/// Cells that may have their middle within a distance of a group of triangles: of its box, and of a
/// triangle alone and its plane.
class RowsNear
{
public:
    RowsNear(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
             double distance)
        : frame_(frame), box_(group.box), triangle_(surface[group.triangles[0]]),
          bound_(surface.bound(group.triangles[0])), isAlone_(group.triangles.size() == 1),
          far_(distance + kFilterRounding * frame.cell),
          isLong_(isAlone_ && box_.sizes().maxCoeff() > kLong * far_)
    {
    }

    /// Calls visit(y, z, run) for rows with a run of such cells.
    template <class Visit>
    void forEachRun(Visit&& visit) const
    {
        const auto [lowY, highY] = rangeOf(box_, 1);
        for (int y = lowY; y <= highY; ++y)
        {
            const Eigen::AlignedBox3d part = partNear(frame_.centre(0, y, 0).y());
            const auto [lowZ, highZ] = rangeOf(part, 2);
            for (int z = lowZ; z <= highZ; ++z)
            {
                const CellRun run = runIn(part, frame_.centre(0, y, z));
                if (run.first <= run.last)
                {
                    visit(y, z, run);
                }
            }
        }
    }

private:
    [[nodiscard]] std::array<int, 2> rangeOf(const Eigen::AlignedBox3d& box, int axis) const
    {
        return frame_.centresWithin(axis, box.min()[axis] - far_, box.max()[axis] + far_);
    }
    /// Returns a box around what of the group may be near a height: the box of a long triangle has
    /// far more cells than are near it.
    [[nodiscard]] Eigen::AlignedBox3d partNear(double y) const
    {
        if (!isLong_)
        {
            return box_;
        }
        Eigen::AlignedBox3d part;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Eigen::Vector3d& a = triangle_.corner[k];
            const Eigen::Vector3d edge = triangle_.corner[(k + 1) % 3] - a;
            const auto [low, high] = std::minmax({a.y(), a.y() + edge.y()});
            if (low > y + far_ || high < y - far_)
            {
                continue;
            }
            for (const double end : {y - far_, y + far_})
            {
                const double share = edge.y() != 0 ? (end - a.y()) / edge.y() : (end - y) / far_;
                part.extend(a + std::clamp(share, 0.0, 1.0) * edge);
            }
        }
        return part;
    }
    /// Returns the cells of the row whose first one has the middle `row`.
    [[nodiscard]] CellRun runIn(const Eigen::AlignedBox3d& part, const Eigen::Vector3d& row) const
    {
        const auto squareBeside = [&](int axis)
        {
            const double outside =
                std::max({0.0, part.min()[axis] - row[axis], row[axis] - part.max()[axis]});
            return outside * outside;
        };
        const double left = far_ * far_ - squareBeside(1) - squareBeside(2);
        if (left < 0)
        {
            return {0, -1};
        }
        const double along = std::sqrt(left);
        double from = part.min().x() - along;
        double to = part.max().x() + along;
        if (const double slope = bound_.normal.x(); isAlone_ && slope != 0)
        {
            const double inPlane = row.x() + (bound_.offset - bound_.normal.dot(row)) / slope;
            const double beside = far_ / std::abs(slope);
            from = std::max(from, inPlane - beside);
            to = std::min(to, inPlane + beside);
        }
        const auto [first, last] = frame_.centresWithin(0, from, to);
        return {first, last};
    }

    static constexpr double kLong = 4; ///< below it a layer has most of the rows

    const GridFrame& frame_;
    const Eigen::AlignedBox3d& box_;
    const SurfaceTriangle& triangle_;
    const TriangleBound& bound_;
    bool isAlone_;
    double far_;
    bool isLong_;
};

/// Finds the cells of a grid whose middle is within `distance` of a group of triangles. Calls
/// visit(y, z, run, isNear) for rows with a run of cells that may be, of which isNear(x) tells.
template <class Visit>
void forEachRunNear(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
                    double distance, Visit&& visit)
{
    const NearGroup near(surface, group, distance);
    if (distance >= 0)
    {
        RowsNear(frame, surface, group, distance)
            .forEachRun(
                [&](int y, int z, CellRun run)
                { visit(y, z, run, [&](int x) { return near.contains(frame.centre(x, y, z)); }); });
    }
}

} // namespace frostfill
