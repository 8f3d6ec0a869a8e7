// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>

namespace frostfill
{

/// A unit sphere about the origin as an icosahedron whose edges are cut into `parts`: 20 parts^2
/// triangles, counter-clockwise seen from outside, with all vertices on the sphere.
[[nodiscard]] TriangleMesh geodesicSphere(std::size_t parts);

} // namespace frostfill
