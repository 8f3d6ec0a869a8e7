// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/rims.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{

/// A lid over any rim, in the direction of the rim: of least area if the rim is short; else the
/// rim's picture in its plane cut into triangles; else a fan about the middle, which adds a vertex.
/// It may cross the mesh, and the fan itself: the windings cancel at every edge all the same.
[[nodiscard]] std::vector<Triangle> largeLid(TriangleMesh& mesh, const EdgeTable& edges,
                                             const Rim& rim);

/// The rim, seen along the normal of its area, cut into triangles: ears, the fattest first
/// [Meisters 1975]. Empty where a part of the rim goes the other way round in that view, or a
/// triangle without area or a chord that is an edge of the mesh already would be needed. Time
/// O(n^2), mostly less.
[[nodiscard]] std::vector<Triangle> clippedLid(const TriangleMesh& mesh, const EdgeTable& edges,
                                               const Rim& rim);

/// A fan of triangles about a new vertex, the middle of the rim.
[[nodiscard]] std::vector<Triangle> fanLid(TriangleMesh& mesh, const Rim& rim);

} // namespace frostfill
