// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Meshes that are hard on a contact search. All enclose a volume; not all are clean.

/// Every triangle cut into three, of which one is a sliver: `height` times as high as the triangle.
[[nodiscard]] TriangleMesh withSlivers(const TriangleMesh& mesh, double height);

/// The first `count` triangles twice.
[[nodiscard]] TriangleMesh withDuplicates(TriangleMesh mesh, std::size_t count);

/// Every `every`-th triangle cut in two at the middle of an edge, its neighbour left whole.
[[nodiscard]] TriangleMesh withTJunctions(const TriangleMesh& mesh, std::size_t every);

/// An upright cylinder of radius 1 and height 2 with so many sides: walls and caps of needles.
[[nodiscard]] TriangleMesh needleCylinder(int sides);

} // namespace frostfill
