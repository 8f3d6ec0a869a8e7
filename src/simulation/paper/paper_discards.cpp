// SPDX-License-Identifier: MIT
#include "simulation/paper/paper_discards.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{

std::size_t discardByHeight(World& world, std::size_t firstFrozen, std::size_t frozenEnd,
                            double epsilon)
{
    if (frozenEnd == 0)
    {
        return firstFrozen;
    }
    const Spheres& s = world.spheres;
    const std::uint32_t lastGroup = s.group(frozenEnd - 1);
    double lowestOfLast = std::numeric_limits<double>::infinity();
    for (std::size_t id = frozenEnd; id > 0 && s.group(id - 1) == lastGroup; --id)
    {
        lowestOfLast = std::min(lowestOfLast, s.position(id - 1).y());
    }

    // Groups go in the order in which they came, so that those that stay remain one range.
    while (firstFrozen < frozenEnd && s.group(firstFrozen) != lastGroup)
    {
        std::size_t end = firstFrozen;
        bool below = true;
        for (; end < frozenEnd && s.group(end) == s.group(firstFrozen); ++end)
        {
            below = below && lowestOfLast - s.position(end).y() > epsilon;
        }
        if (!below)
        {
            break;
        }
        for (; firstFrozen < end; ++firstFrozen)
        {
            world.spheres.discard(static_cast<std::uint32_t>(firstFrozen));
        }
    }
    return firstFrozen;
}

namespace
{

/// Whether the ray from `vertex` along `direction` enters a sphere at rest within `closeness`.
bool isCovered(const World& world, const Eigen::Vector3d& vertex, const Eigen::Vector3d& direction,
               double closeness)
{
    bool covered = false;
    // Centres of spheres that the ray enters that soon are within this of the ray's first half.
    const double reach = 1 + closeness / 2;
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachNear(vertex + direction * (closeness / 2), reach,
                        [&](std::uint32_t row)
                        {
                            const Eigen::Vector3d toCentre = resting[row].position() - vertex;
                            const double radius = resting[row].radius;
                            const double along = toCentre.dot(direction);
                            const double missSquared = (toCentre - along * direction).squaredNorm();
                            if (along >= 0 && missSquared <= radius * radius)
                            {
                                const double entry =
                                    along - std::sqrt(radius * radius - missSquared);
                                covered = covered || entry <= closeness;
                            }
                        });
    return covered;
}

} // namespace

std::size_t discardCoveredPolygons(World& world, double closeness)
{
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < world.surface.size(); ++t)
    {
        if (world.polygons[t] == PolygonState::discarded)
        {
            continue;
        }
        const SurfaceTriangle& triangle = world.surface[t];
        bool covered = true;
        for (std::size_t k = 0; k < 3 && covered; ++k)
        {
            const Eigen::Vector3d normal =
                world.surface.vertexNormal(world.surface.mesh().triangles[t][k]);
            covered = isCovered(world, triangle.corner[k], normal, closeness);
        }
        if (covered)
        {
            world.discardPolygon(t);
            ++count;
        }
    }
    return count;
}

} // namespace frostfill
