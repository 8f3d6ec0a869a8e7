// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"
#include "mesh/interior/triangle_tree.hpp"

namespace frostfill
{

/// What the search for walls, the thickness and the surface all need of one mesh, made once. It
/// also serves the mesh when that is moved, turned or scaled.
struct MeshIndex
{
    explicit MeshIndex(const TriangleMesh& mesh) : edges(mesh), tree(mesh, kSmallLeaf) {}

    EdgeTable edges;
    TriangleTree tree; ///< with kSmallLeaf
};

} // namespace frostfill
