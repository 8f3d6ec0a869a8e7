// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Merges all vertices with the same position into the first of them. Keeps the order.
void weldEqualVertices(TriangleMesh& mesh);

/// Merges vertices on the rims of holes that are closer than `distance`.
/// Returns the number of removed vertices.
std::size_t weldRims(TriangleMesh& mesh, double distance);

} // namespace frostfill
