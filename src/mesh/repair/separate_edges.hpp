// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Cuts the surface apart along edges where two solid wedges touch (four, six, ... triangles that
/// alternate in winding), by giving each wedge vertices of its own. Returns the number of edges
/// that were cut. Edges with any other constellation stay as they are.
std::size_t separateTouchingEdges(TriangleMesh& mesh);

} // namespace frostfill
