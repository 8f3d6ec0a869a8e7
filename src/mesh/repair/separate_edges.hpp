// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Cuts the surface along edges where solid wedges touch: edges of four, six, ... triangles with
/// alternating windings. Each wedge gets its own vertices. Other edges stay as they are. Returns
/// the number of cut edges.
std::size_t separateTouchingEdges(TriangleMesh& mesh);

} // namespace frostfill
