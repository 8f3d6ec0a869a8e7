// SPDX-License-Identifier: MIT
// Room: inspection and repair of meshes from outside. Each step changes a TriangleMesh and
// reports what it did.
#pragma once

#include <frostfill/mesh.hpp>

#include <optional>
#include <string>

namespace frostfill
{

/// Each function returns the number of elements that it has removed.

/// Removes triangles without area. Merely dropping one between its neighbours would leave a slit,
/// so it is merged into the neighbour along its longest edge.
std::size_t dropFlatTriangles(TriangleMesh& mesh);

/// Removes all but one of the triangles with the same vertices. Two triangles that face opposite
/// ways, as between two solids glued together, are both removed if that improves the connected
/// piece that they belong to and leaves something of it.
std::size_t dropDuplicateTriangles(TriangleMesh& mesh);

std::size_t dropUnusedVertices(TriangleMesh& mesh);

/// Returns a sentence about data that are no mesh: a vertex that is not finite or too far away to
/// compute with, or a triangle that names a missing vertex. Its numbers count from 1.
[[nodiscard]] std::optional<std::string> findInvalidData(const TriangleMesh& mesh);

} // namespace frostfill
