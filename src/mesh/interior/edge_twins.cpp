// SPDX-License-Identifier: MIT
#include "mesh/interior/edge_twins.hpp"

namespace frostfill
{
namespace
{

/// The sides that run from one vertex to another.
struct Sides
{
    std::uint32_t last = EdgeTwins::kNone;
    std::size_t count = 0;
};

Sides sidesFrom(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                std::uint32_t from, std::uint32_t to)
{
    Sides sides;
    for (const std::uint32_t triangle : triangles)
    {
        const auto& t = mesh.triangles[triangle];
        for (std::uint32_t k = 0; k < 3; ++k)
        {
            if (t[k] == from && t[(k + 1) % 3] == to)
            {
                sides.last = 3 * triangle + k;
                ++sides.count;
            }
        }
    }
    return sides;
}

} // namespace

EdgeTwins::EdgeTwins(const TriangleMesh& mesh, const VertexTriangles& around)
    : twins_(3 * mesh.triangles.size(), kNone)
{
    for (std::uint32_t side = 0; side < twins_.size(); ++side)
    {
        if (twins_[side] != kNone)
        {
            continue;
        }
        const auto& t = mesh.triangles[side / 3];
        const std::uint32_t from = t[side % 3];
        const std::uint32_t to = t[(side % 3 + 1) % 3];
        // The vertex with fewer triangles: the hub of a fan would be searched for each spoke.
        const auto atFrom = around.at(from);
        const auto atTo = around.at(to);
        const auto triangles = atFrom.size() < atTo.size() ? atFrom : atTo;
        const Sides same = sidesFrom(mesh, triangles, from, to);
        const Sides opposite = sidesFrom(mesh, triangles, to, from);
        if (same.count == 1 && same.last == side && opposite.count == 1)
        {
            twins_[side] = opposite.last;
            twins_[opposite.last] = side;
        }
    }
}

bool EdgeTwins::isOneFan(const TriangleMesh& mesh, std::uint32_t vertex,
                         std::span<const std::uint32_t> triangles) const
{
    const std::uint32_t first = triangles[0];
    std::uint32_t triangle = first;
    std::size_t passed = 0;
    do
    {
        // The next triangle of the fan is across the side that ends at the vertex.
        const auto& t = mesh.triangles[triangle];
        const std::uint32_t before = t[0] == vertex ? 2 : (t[1] == vertex ? 0 : 1);
        const std::uint32_t twin = twins_[3 * triangle + before];
        if (twin == kNone)
        {
            return false;
        }
        triangle = twin / 3;
        ++passed;
    } while (triangle != first);
    return passed == triangles.size();
}

} // namespace frostfill
