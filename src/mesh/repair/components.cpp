// SPDX-License-Identifier: MIT
#include "mesh/repair/components.hpp"

namespace frostfill
{

std::vector<std::vector<std::uint32_t>> connectedPieces(const TriangleMesh& mesh,
                                                        const EdgeTable& edges)
{
    DisjointSets sets(mesh.triangles.size());
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (const EdgeUse& use : uses.subspan(1))
            {
                sets.join(uses[0].triangle, use.triangle);
            }
        });

    std::vector<std::vector<std::uint32_t>> pieces;
    std::vector<std::size_t> pieceOf(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        if (repeatsCorner(mesh.triangles[triangle]))
        {
            continue;
        }
        const std::size_t root =
            sets.find(triangle); // the smallest, so it has already been visited
        if (root == triangle)
        {
            pieceOf[triangle] = pieces.size();
            pieces.emplace_back();
        }
        pieces[pieceOf[root]].push_back(static_cast<std::uint32_t>(triangle));
    }
    return pieces;
}

void PieceSize::add(const TriangleMesh& mesh, const Triangle& t, const Eigen::Vector3d& origin)
{
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const Eigen::Vector3d& b = mesh.vertices[t[1]];
    const Eigen::Vector3d& c = mesh.vertices[t[2]];
    volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
    area += areaOf(mesh, t);
    box.extend(a).extend(b).extend(c);
}

std::size_t joinCorners(DisjointSets& corners, const TriangleMesh& mesh, const EdgeUse& a,
                        const EdgeUse& b)
{
    const auto cornerAt = [&](const EdgeUse& use, std::uint32_t vertex)
    {
        const std::size_t next = (use.corner + 1U) % 3U;
        const bool starts = mesh.triangles[use.triangle][use.corner] == vertex;
        return 3 * std::size_t{use.triangle} + (starts ? use.corner : next);
    };
    const bool low = corners.join(cornerAt(a, a.low), cornerAt(b, a.low));
    const bool high = corners.join(cornerAt(a, a.high), cornerAt(b, a.high));
    return (low ? 1U : 0U) + (high ? 1U : 0U);
}

} // namespace frostfill
