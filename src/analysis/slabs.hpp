// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <vector>

namespace frostfill
{

/// Volume of a ball about the origin below the plane at `height`: a cap, all, or nothing.
[[nodiscard]] double ballBelow(double radius, double height);

/// Volume between the planes k and k + 1 of `heights`, ascending coordinates along an axis, of a
/// closed mesh that does not pass through itself. Exact: of the triangles below a plane, by the
/// divergence theorem with a field along another axis, to which the plane adds nothing.
[[nodiscard]] std::vector<double> meshSlabs(const TriangleMesh& mesh, Eigen::Index axis,
                                            const std::vector<double>& heights);

} // namespace frostfill
