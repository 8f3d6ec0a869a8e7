// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Makes one vertex of all with the same position; the first of them stays, in order.
void weldEqualVertices(TriangleMesh& mesh);

/// Makes one vertex of those on the rims of holes that are closer than `distance`.
/// Returns how many vertices have gone.
std::size_t weldRims(TriangleMesh& mesh, double distance);

} // namespace frostfill
