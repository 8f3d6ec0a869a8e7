// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/mesh_index.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <vector>

namespace frostfill
{

/// Which triangles of a closed mesh act from both sides. The pseudonormal of the nearest triangle
/// tells the side only where the surface does not meet itself and parts outside from inside
/// [Baerentzen & Aanaes 2005]. Near the others the winding number must decide.
struct Walls
{
    std::vector<bool> twoSided;                              ///< [#T]
    std::size_t count = 0;                                   ///< of two-sided triangles
    std::size_t crossed = 0;                                 ///< of triangles that meet others
    Eigen::Vector3d firstCrossing = Eigen::Vector3d::Zero(); ///< if there are crossed triangles

    /// Whether the pseudonormal is right everywhere.
    [[nodiscard]] bool none() const { return count == 0; }
};

/// Two-sided are
/// - triangles that meet others elsewhere than at shared vertices and edges (findCrossings),
/// - triangles without area, triangles at edges that do not have exactly two triangles with
/// opposite
///   directions, and triangles at vertices where several fans touch,
/// - patches of the rest whose winding number is not 0 in front and 1 behind, such as a shell
/// within
///   a shell of the same direction,
/// - all triangles that share a vertex with one of these.
/// A mesh of one piece without any of these is taken to be wound outwards.
[[nodiscard]] Walls classifyWalls(const TriangleMesh& mesh);
/// With its index, for who has it already.
[[nodiscard]] Walls classifyWalls(const TriangleMesh& mesh, const MeshIndex& index);

} // namespace frostfill
