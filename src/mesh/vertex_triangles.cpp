// SPDX-License-Identifier: MIT
#include "mesh/vertex_triangles.hpp"

#include "mesh/triangle_shape.hpp"

#include <numeric>

namespace frostfill
{
namespace
{

template <class Visit>
void forEachCorner(const TriangleMesh& mesh, Visit&& visit)
{
    for (std::size_t triangle = mesh.triangles.size(); triangle-- > 0;)
    {
        const auto& t = mesh.triangles[triangle];
        if (!repeatsCorner(t))
        {
            visit(t[0], static_cast<std::uint32_t>(triangle));
            visit(t[1], static_cast<std::uint32_t>(triangle));
            visit(t[2], static_cast<std::uint32_t>(triangle));
        }
    }
}

} // namespace

VertexTriangles::VertexTriangles(const TriangleMesh& mesh) : starts_(mesh.vertices.size() + 1, 0)
{
    // Count, sum up the ends, and fill each list from its end.
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t) { ++starts_[vertex]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    triangles_.resize(starts_.back());
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t triangle)
                  { triangles_[--starts_[vertex]] = triangle; });
}

} // namespace frostfill
