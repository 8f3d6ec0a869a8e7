// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_tree.hpp"
#include "mesh/vertex_triangles.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The triangles of a mesh that meet others elsewhere than at shared vertices and edges.
struct Crossings
{
    std::vector<bool> crossed;                            ///< [#T]
    std::size_t count = 0;                                ///< of crossed triangles
    Eigen::Vector3d firstPlace = Eigen::Vector3d::Zero(); ///< where the first of them does so

    [[nodiscard]] bool none() const { return count == 0; }
};

/// Finds all triangles that meet others. Exact, see orient3d. To touch counts, and so do overlaps
/// in a plane and a fold flat onto a neighbour. Vertices are the same if their indices are: where
/// two vertices have the same coordinates, two sheets touch, and the nearer one cannot tell the
/// side. Triangles without area are left out. `around` and `tree`: of the mesh. Takes O(n log n)
/// plus the number of pairs whose boxes meet, which is O(n) except for needles that lie askew side
/// by side.
[[nodiscard]] Crossings findCrossings(const TriangleMesh& mesh, const VertexTriangles& around,
                                      const TriangleTree& tree, Threads& threads);

/// Whether the triangles at a vertex surely meet nowhere but at their common corners and edges:
/// they form one closed fan which, seen along the mean of their normals, turns about the vertex
/// once and never backwards. Seen so they lie side by side. Answers no where rounding could matter,
/// and for more than a dozen or so triangles. All triangles have the vertex as a corner.
[[nodiscard]] bool isSpreadFan(const TriangleMesh& mesh, std::uint32_t vertex,
                               std::span<const std::uint32_t> triangles);

} // namespace frostfill
