// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

namespace frostfill
{

/// Merges all vertices with the same position into the first of them. Keeps the order.
void weldEqualVertices(TriangleMesh& mesh);

/// [#V] whether an edge of only one triangle ends there.
[[nodiscard]] std::vector<bool> verticesOnRims(const TriangleMesh& mesh, const EdgeTable& edges);

/// Merges vertices on the rims of holes that are closer than `distance`.
/// Returns the number of removed vertices.
std::size_t weldRims(TriangleMesh& mesh, double distance);

} // namespace frostfill
