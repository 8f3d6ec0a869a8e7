// SPDX-License-Identifier: MIT
#include "mesh/repair/pieces.hpp"

#include <cmath>
#include <unordered_map>

namespace frostfill
{

std::vector<Rim> findRims(const EdgeTable& edges)
{
    NextVertices next;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() != 1)
            {
                return;
            }
            const EdgeUse& use = uses[0]; // the lid runs opposite to the triangle
            next.emplace(use.forward ? use.high : use.low, use.forward ? use.low : use.high);
        });
    return closedPaths(std::move(next));
}

std::vector<Rim> closedPaths(NextVertices next)
{
    std::vector<Rim> rims;
    std::unordered_map<std::uint32_t, std::size_t> placeInPath;
    while (!next.empty())
    {
        Rim path = {next.begin()->first};
        placeInPath = {{path[0], 0}};
        for (auto step = next.begin(); step != next.end(); step = next.find(path.back()))
        {
            const std::uint32_t vertex = step->second;
            next.erase(step);
            // A rim is complete where the path meets itself.
            const auto [loop, isNew] = placeInPath.try_emplace(vertex, path.size());
            if (isNew)
            {
                path.push_back(vertex);
                continue;
            }
            const std::size_t begin = loop->second;
            rims.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end());
            for (; path.size() > begin + 1; path.pop_back())
            {
                placeInPath.erase(path.back());
            }
        }
    }
    return rims;
}

Eigen::Vector3d middleOf(const TriangleMesh& mesh, const Rim& rim)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t vertex : rim)
    {
        middle += mesh.vertices[vertex] / static_cast<double>(rim.size());
    }
    return middle;
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

bool PieceSize::isEnvelope() const
{
    constexpr double kThinnest = 1e-6; // [1] below what any format's rounding makes of a flat sheet
    return !(std::abs(volume) > kThinnest * area * box.diagonal().norm());
}

Pieces::Pieces(const TriangleMesh& mesh, const EdgeTable& edges) : of(mesh.triangles.size(), kNone)
{
    DisjointSets sets =
        connectedOver(edges, mesh.triangles.size(), [](auto /*uses*/) { return true; });
    const auto originOf = [&](const Piece& piece) -> const Eigen::Vector3d&
    { return mesh.vertices[mesh.triangles[piece.triangles[0]][0]]; };
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        if (repeatsCorner(mesh.triangles[triangle]))
        {
            continue;
        }
        const std::size_t root = sets.find(triangle); // the smallest, which has been here already
        if (root == triangle)
        {
            of[triangle] = all.size();
            all.emplace_back();
        }
        of[triangle] = of[root];
        Piece& piece = all[of[root]];
        piece.triangles.push_back(triangle);
        piece.size.add(mesh, mesh.triangles[triangle], originOf(piece));
    }
    edges.forEach([&](std::span<const EdgeUse> uses)
                  { all[of[uses[0].triangle]].openEdges += uses.size() == 1 ? 1 : 0; });
    for (const Rim& rim : findRims(edges))
    {
        Piece& piece = all[of[edges.find(rim[0], rim[1])[0].triangle]];
        const Eigen::Vector3d& origin = originOf(piece);
        const Eigen::Vector3d middle = middleOf(mesh, rim) - origin;
        piece.edgesOfRims += rim.size();
        for (std::size_t i = 0; i < rim.size(); ++i)
        {
            const Eigen::Vector3d a = mesh.vertices[rim[i]] - origin;
            const Eigen::Vector3d b = mesh.vertices[rim[(i + 1) % rim.size()]] - origin;
            piece.size.volume += a.dot(b.cross(middle)) / 6;
            piece.lids += 0.5 * (a - middle).cross(b - middle).norm();
        }
    }
}

} // namespace frostfill
