// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_tree.hpp"
#include "mesh/vertex_triangles.hpp"

#include <cstddef>
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

} // namespace frostfill
