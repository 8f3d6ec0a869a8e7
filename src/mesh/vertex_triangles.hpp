// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{

/// The triangles at each vertex, ascending. A triangle that repeats a corner is at none.
class VertexTriangles
{
public:
    explicit VertexTriangles(const TriangleMesh& mesh)
        : triangles_(mesh.vertices.size(),
                     [&](auto&& enter)
                     {
                         for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
                         {
                             const Triangle& corners = mesh.triangles[t];
                             for (std::size_t k = 0; k < 3 && !repeatsCorner(corners); ++k)
                             {
                                 enter(corners[k], t);
                             }
                         }
                     })
    {
    }

    [[nodiscard]] std::size_t vertices() const { return triangles_.size(); }
    [[nodiscard]] std::span<const std::uint32_t> at(std::size_t vertex) const
    {
        return triangles_[vertex];
    }

private:
    Buckets<std::uint32_t> triangles_;
};

} // namespace frostfill
