// SPDX-License-Identifier: MIT
#include "simulation/quality/resting_contacts.hpp"

#include "simulation/quality/tolerances.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

std::uint32_t spheresBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    const double radius = world.spheres.radius(id);
    const double gap = kContactGap * radius;
    std::uint32_t count = 0;
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachNear(p, radius + 1 + gap,
                        [&](std::uint32_t row)
                        {
                            const double distance = (p - resting[row].position()).norm();
                            const double depth = radius + resting[row].radius - distance;
                            const bool isOther = resting.id(row) != id && distance > 0;
                            count += isOther && depth > -gap ? 1 : 0;
                        });
    return count;
}

double distanceToEdge(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const Eigen::Vector3d along = b - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - share * along).norm();
}

/// Edges of near triangles, by the vertices at their ends, the lower one first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Pieces into which triangles fall that meet at these edges. Each edge has the number of its
/// triangle, below `triangles`.
std::uint32_t piecesOf(std::size_t triangles, std::vector<std::pair<Edge, std::size_t>>& edges)
{
    std::vector<std::size_t> piece(triangles);
    std::iota(piece.begin(), piece.end(), std::size_t{0});
    const auto root = [&](std::size_t t)
    {
        while (piece[t] != t)
        {
            t = piece[t];
        }
        return t;
    };
    std::sort(edges.begin(), edges.end());
    auto pieces = static_cast<std::uint32_t>(triangles);
    for (std::size_t k = 1; k < edges.size(); ++k)
    {
        const std::size_t a = root(edges[k - 1].second);
        const std::size_t b = root(edges[k].second);
        if (edges[k - 1].first == edges[k].first && a != b)
        {
            piece[b] = a;
            --pieces;
        }
    }
    return pieces;
}

std::uint32_t wallsBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    const double reach = world.spheres.radius(id) * (1 + kContactGap);
    std::size_t triangles = 0;
    std::vector<std::pair<Edge, std::size_t>> edges;
    std::vector<std::uint32_t> nearby;
    for (const std::uint32_t t : world.triangles.near(p, reach, nearby))
    {
        if (!world.surface.bound(t).mayBeWithin(reach, p))
        {
            continue;
        }
        const auto& corner = world.surface[t].corner;
        const double distance =
            (p - closestPointOnTriangle(p, corner[0], corner[1], corner[2]).point).norm();
        if (distance > reach || distance <= kOnWall)
        {
            continue;
        }
        const auto& vertices = world.surface.mesh().triangles[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::size_t next = (k + 1) % 3;
            if (distanceToEdge(p, corner[k], corner[next]) <= reach)
            {
                edges.push_back({std::minmax(vertices[k], vertices[next]), triangles});
            }
        }
        ++triangles;
    }
    return piecesOf(triangles, edges);
}

} // namespace

std::uint32_t restingContacts(const World& world, std::uint32_t id)
{
    const Eigen::Vector3d p = world.spheres.position(id);
    if (world.spheres.isRunning(id) || !p.allFinite())
    {
        return 0;
    }
    return spheresBeside(world, id, p) + wallsBeside(world, id, p);
}

} // namespace frostfill
