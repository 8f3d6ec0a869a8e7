// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// PAPER, equation 3: advances past every group whose spheres all lie more than `epsilon` below all
/// spheres of the last frozen group, and discards its spheres. A heuristic: height says nothing
/// about the pocket that a sphere is in. `firstFrozen` is the id of the first sphere of group FFG,
/// `frozenEnd` the id after the last frozen sphere. Returns the new firstFrozen.
[[nodiscard]] std::size_t discardByHeight(World& world, std::size_t firstFrozen,
                                          std::size_t frozenEnd, double epsilon);

/// PAPER, 1.2: discards polygons that are covered: from each of the three vertices the ray along
/// the vertex normal, into the object, meets a sphere at rest whose gap to the polygon is at most
/// `closeness`. A heuristic: the polygon may be within reach between its vertices.
/// Returns how many polygons were discarded.
std::size_t discardCoveredPolygons(World& world, double closeness);

} // namespace frostfill
