// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Each returns how much it has removed.

/// Triangles without area. One that lies between its neighbours is not just dropped, which would
/// leave a slit, but handed over to the neighbour along its longest edge.
std::size_t dropFlatTriangles(TriangleMesh& mesh);

/// All but one of the triangles with the same vertices; of a pair that faces both ways, as where
/// two solids have been glued together, both when that leaves the better surface.
std::size_t dropDuplicateTriangles(TriangleMesh& mesh);

std::size_t dropUnusedVertices(TriangleMesh& mesh);

} // namespace frostfill
