// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// The triangles at an edge in the order of a turn about it.
[[nodiscard]] std::vector<EdgeUse> sortedAround(const TriangleMesh& mesh,
                                                std::span<const EdgeUse> uses);

/// Cuts the surface along edges where solid wedges touch: edges of four, six, ... triangles with
/// alternating windings. Each wedge gets its own vertices. Other edges stay as they are. Returns
/// the number of cut edges.
std::size_t separateTouchingEdges(TriangleMesh& mesh);

} // namespace frostfill
