// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// A box, each face cut into cuts x cuts quads.
[[nodiscard]] TriangleMesh cutBoxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                                      int cuts = 8);

/// Every triangle wound the other way.
[[nodiscard]] TriangleMesh insideOut(TriangleMesh mesh);

/// Moved, after having been scaled and rotated about the origin.
[[nodiscard]] TriangleMesh moved(TriangleMesh mesh, double scale, const Eigen::Matrix3d& rotation,
                                 const Eigen::Vector3d& offset);

} // namespace frostfill
