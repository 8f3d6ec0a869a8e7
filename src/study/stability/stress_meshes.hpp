// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Meshes that are hard on a contact search. All enclose a volume; not all are clean.

/// A box, each face cut into cuts x cuts quads.
[[nodiscard]] TriangleMesh boxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                                   int cuts = 8);

/// Every triangle cut into three, of which one is a sliver: `height` times as high as the triangle.
[[nodiscard]] TriangleMesh withSlivers(const TriangleMesh& mesh, double height);

/// The first `count` triangles twice.
[[nodiscard]] TriangleMesh withDuplicates(TriangleMesh mesh, std::size_t count);

/// Every `every`-th triangle cut in two at the middle of an edge, its neighbour left whole.
[[nodiscard]] TriangleMesh withTJunctions(const TriangleMesh& mesh, std::size_t every);

/// Every triangle wound the other way.
[[nodiscard]] TriangleMesh insideOut(TriangleMesh mesh);

/// An upright cylinder of radius 1 and height 2 with so many sides: walls and caps of needles.
[[nodiscard]] TriangleMesh needleCylinder(int sides);

/// Moved, after having been scaled and rotated about the origin.
[[nodiscard]] TriangleMesh moved(TriangleMesh mesh, double scale, const Eigen::Matrix3d& rotation,
                                 const Eigen::Vector3d& offset);

} // namespace frostfill
