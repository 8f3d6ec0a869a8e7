// SPDX-License-Identifier: MIT
#include "simulation/quality/resting_contacts.hpp"

#include "simulation/quality/beside.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

std::uint32_t spheresBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    std::uint32_t count = 0;
    forEachSphereBeside(world.spheres.resting(), id, p, world.spheres.radius(id),
                        [&](std::uint32_t, const Eigen::Vector3d& apart, double)
                        { count += apart.isZero(0) ? 0 : 1; });
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
    const double radius = world.spheres.radius(id);
    const double reach = radius * (1 + kContactGap);
    std::size_t triangles = 0;
    std::vector<std::pair<Edge, std::size_t>> edges;
    std::vector<std::uint32_t> nearby;
    const auto enter = [&](std::uint32_t t, const Eigen::Vector3d&, double distance)
    {
        if (distance <= kOnWall)
        {
            return;
        }
        const auto& corner = world.surface[t].corner;
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
    };
    forEachTriangleBeside(world, p, radius, nearby, enter);
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
