// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/rims.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{

/// The time for a lid of least area grows with the cube of the edges, the memory with their square.
/// A rim of so many takes a tenth of a second.
inline constexpr std::size_t kMaxEdgesOfLeastLid = 400;

/// The lid of least area over a rim, in the direction of the rim, without new vertices. Empty if
/// there is none: each has a triangle without area or a chord that is an edge of the mesh already.
[[nodiscard]] std::vector<Triangle> leastLid(const TriangleMesh& mesh, const EdgeTable& edges,
                                             const Rim& rim);

} // namespace frostfill
