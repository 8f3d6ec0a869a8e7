// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{

/// The triangles of each piece. Shared edges connect the triangles of a piece. Pieces are in the
/// order of their first triangle. Triangles that repeat a corner belong to no piece.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> connectedPieces(const TriangleMesh& mesh,
                                                                      const EdgeTable& edges);

/// Of triangles that are added one after the other.
struct PieceSize
{
    double volume = 0; ///< [unit^3] signed, of the cones from a point to them
    double area = 0;   ///< [unit^2]
    Eigen::AlignedBox3d box;

    void add(const TriangleMesh& mesh, const Triangle& t, const Eigen::Vector3d& origin);
};

/// Joins the corners (3 x triangle + corner) of two triangles that meet along an edge. Returns how
/// many of the two pairs were apart.
std::size_t joinCorners(DisjointSets& corners, const TriangleMesh& mesh, const EdgeUse& a,
                        const EdgeUse& b);

} // namespace frostfill
