// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "mesh/interior/near_triangle.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace frostfill
{

/// Triangles that lie side by side, or one.
struct TriangleGroup
{
    std::span<const std::uint32_t> triangles;
    Eigen::AlignedBox3d box; ///< around them
};

/// Calls visit(group) for all triangles of a surface, in the order of its tree. Those that are
/// small ask together what they are near: a group is no longer than `longest`, unless it is one
/// triangle. Larger: more of what is asked for a group has to be asked for each of its triangles.
template <class Visit>
void forEachGroup(const Surface& surface, std::span<const std::uint32_t> triangles, double longest,
                  Visit&& visit)
{
    TriangleGroup group{triangles, {}};
    for (const std::uint32_t t : triangles)
    {
        for (const Eigen::Vector3d& corner : surface[t].corner)
        {
            group.box.extend(corner);
        }
    }
    if (triangles.size() == 1 || group.box.sizes().maxCoeff() <= longest)
    {
        visit(group);
        return;
    }
    forEachGroup(surface, triangles.first(triangles.size() / 2), longest, visit);
    forEachGroup(surface, triangles.subspan(triangles.size() / 2), longest, visit);
}
/// Triangles that follow each other in the tree, among which groups are looked for.
inline constexpr std::size_t kTogether = 16;
[[nodiscard]] inline std::size_t countOfParts(const Surface& surface)
{
    return (surface.size() + kTogether - 1) / kTogether;
}
/// Calls visit(group) for the triangles of one such part.
template <class Visit>
void forEachGroupOfPart(const Surface& surface, std::size_t part, double longest, Visit&& visit)
{
    const auto left = surface.tree().order().subspan(part * kTogether);
    forEachGroup(surface, left.first(std::min(kTogether, left.size())), longest, visit);
}
template <class Visit>
void forEachGroup(const Surface& surface, double longest, Visit&& visit)
{
    for (std::size_t part = 0; part < countOfParts(surface); ++part)
    {
        forEachGroupOfPart(surface, part, longest, visit);
    }
}
/// The same groups, on several threads.
template <class Visit>
void forEachGroup(const Surface& surface, double longest, Threads& threads, Visit&& visit)
{
    threads.forEach(countOfParts(surface),
                    [&](std::size_t part) { forEachGroupOfPart(surface, part, longest, visit); });
}

/// The squared distances of a coordinate to the nearest and the farthest of a box, along one axis:
/// those of three axes add up.
struct SquaresToBox
{
    double nearest;
    double farthest;

    SquaresToBox(const Eigen::AlignedBox3d& box, Eigen::Index axis, double coordinate)
    {
        const double below = box.min()[axis] - coordinate;
        const double above = coordinate - box.max()[axis];
        const double outside = std::max({below, above, 0.0});
        const double across = std::min(below, above);
        nearest = outside * outside;
        farthest = across * across;
    }
};

} // namespace frostfill
