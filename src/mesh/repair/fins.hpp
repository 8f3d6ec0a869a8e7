// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Removes fins: parts of a surface that end in the open and hang on the rest by edges of three
/// triangles or more, where the rest closes without them. They enclose nothing. Returns the number
/// of removed triangles; 0 if they would be most of the surface.
std::size_t dropFins(TriangleMesh& mesh);

/// Removes open pieces that no lid of a small hole closes, beside closed pieces with most of the
/// surface. Returns the number of removed triangles.
std::size_t dropOpenPieces(TriangleMesh& mesh);

} // namespace frostfill
