// SPDX-License-Identifier: MIT
#include "simulation/quality/wall_pieces.hpp"

#include "mesh/connectivity.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

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
    DisjointSets sets(triangles);
    std::sort(edges.begin(), edges.end());
    auto pieces = static_cast<std::uint32_t>(triangles);
    for (std::size_t k = 1; k < edges.size(); ++k)
    {
        if (edges[k - 1].first == edges[k].first && sets.join(edges[k - 1].second, edges[k].second))
        {
            --pieces;
        }
    }
    return pieces;
}

} // namespace

std::uint32_t wallPieces(const Surface& surface, std::span<const std::uint32_t> triangles,
                         const Eigen::Vector3d& p, double reach, double onWall)
{
    std::size_t count = 0;
    std::vector<std::pair<Edge, std::size_t>> edges;
    for (const std::uint32_t t : triangles)
    {
        const auto& corner = surface[t].corner;
        const double distance =
            (p - closestPointOnTriangle(p, corner[0], corner[1], corner[2]).point).norm();
        if (distance > reach || distance <= onWall)
        {
            continue;
        }
        const auto& vertices = surface.mesh().triangles[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::size_t next = (k + 1) % 3;
            if (distanceToEdge(p, corner[k], corner[next]) <= reach)
            {
                edges.push_back({std::minmax(vertices[k], vertices[next]), count});
            }
        }
        ++count;
    }
    return piecesOf(count, edges);
}

} // namespace frostfill
