// SPDX-License-Identifier: MIT
#include "mesh/repair/separate_edges.hpp"

#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <cmath>
#include <optional>

namespace frostfill
{
namespace
{

using Pairs = std::vector<std::array<EdgeUse, 2>>;

/// The two sides of each solid wedge at an edge; empty if the windings do not alternate.
std::optional<Pairs> solidWedges(const TriangleMesh& mesh, std::span<const EdgeUse> uses)
{
    // On a turn about the edge, a backward triangle leads into the solid and a forward one out of
    // it.
    const std::vector<EdgeUse> around = sortedAround(mesh, uses);
    Pairs pairs;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
        const EdgeUse& here = around[i];
        const EdgeUse& next = around[(i + 1) % around.size()];
        if (here.forward == next.forward)
        {
            return std::nullopt;
        }
        if (next.forward)
        {
            pairs.push_back({here, next});
        }
    }
    return pairs;
}

} // namespace

std::vector<EdgeUse> sortedAround(const TriangleMesh& mesh, std::span<const EdgeUse> uses)
{
    const Eigen::Vector3d& start = mesh.vertices[uses[0].low];
    const Eigen::Vector3d axis = (mesh.vertices[uses[0].high] - start).normalized();
    const Eigen::Vector3d u = axis.unitOrthogonal();
    const Eigen::Vector3d v = axis.cross(u);
    std::vector<std::pair<double, EdgeUse>> around;
    for (const EdgeUse& use : uses)
    {
        const std::uint32_t third = mesh.triangles[use.triangle][(use.corner + 2U) % 3U];
        const Eigen::Vector3d arm = mesh.vertices[third] - start;
        around.emplace_back(std::atan2(arm.dot(v), arm.dot(u)), use);
    }
    std::sort(around.begin(), around.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<EdgeUse> sorted;
    for (const auto& [angle, use] : around)
    {
        sorted.push_back(use);
    }
    return sorted;
}

std::size_t separateTouchingEdges(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    DisjointSets corners(3 * mesh.triangles.size());
    std::vector<bool> atCut(mesh.vertices.size(), false);
    std::size_t cuts = 0;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto wedges = uses.size() > 2 ? solidWedges(mesh, uses) : std::nullopt;
            if (wedges)
            {
                for (const auto& [one, other] : *wedges)
                {
                    joinCorners(corners, mesh, one, other);
                }
                atCut[uses[0].low] = atCut[uses[0].high] = true;
                ++cuts;
            }
            else
            {
                for (const EdgeUse& use : uses.subspan(1))
                {
                    joinCorners(corners, mesh, uses[0], use);
                }
            }
        });
    if (cuts == 0)
    {
        return 0;
    }

    // The first fan at a vertex keeps it; each other fan gets a copy.
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<std::uint32_t> vertexOf(3 * mesh.triangles.size(), kNone);
    std::vector<bool> taken(mesh.vertices.size(), false);
    for (std::size_t corner = 0; corner < vertexOf.size(); ++corner)
    {
        std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
        std::uint32_t& fan = vertexOf[corners.find(corner)];
        if (!atCut[vertex])
        {
            continue;
        }
        if (fan == kNone)
        {
            fan = vertex;
            if (taken[vertex])
            {
                fan = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(Eigen::Vector3d(mesh.vertices[vertex]));
                atCut.push_back(false);
            }
            taken[vertex] = true;
        }
        vertex = fan;
    }
    return cuts;
}

} // namespace frostfill
