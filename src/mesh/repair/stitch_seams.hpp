// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

#include <frostfill/mesh.hpp>

#include <string>

namespace frostfill
{

/// Splits open edges at the vertices of rims that lie on them, no farther away than `distance`, and
/// not at their ends: T-junctions, where one side of a seam has vertices that the other lacks.
/// Returns the number of splits; 0, and leaves the mesh as it is, if there would be more than a few
/// for each open edge.
std::size_t splitAtTJunctions(TriangleMesh& mesh, double distance);

/// Joins the two sides of open seams: vertices of rims that nearly meet, and T-junctions. Distances
/// grow as long as edges stay open. The smallest is used if it improves the surface, a larger one
/// only if it closes it. Returns a sentence for each repair.
std::vector<std::string> stitchSeams(TriangleMesh& mesh);

/// Merges all vertices with the same position into the first of them. Keeps the order.
void weldEqualVertices(TriangleMesh& mesh);

/// [#V] whether an edge of only one triangle ends there.
[[nodiscard]] std::vector<bool> verticesOnRims(const TriangleMesh& mesh, const EdgeTable& edges);

/// Merges vertices on the rims of holes that are closer than `distance`.
/// Returns the number of removed vertices.
std::size_t weldRims(TriangleMesh& mesh, double distance);

} // namespace frostfill
