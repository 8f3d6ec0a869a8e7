// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstdint>
#include <span>

namespace frostfill
{

/// Whether the triangles at a vertex surely meet nowhere but at their common corners and edges:
/// they form one closed fan which, seen along the mean of their normals, turns about the vertex
/// once and never backwards. Seen so they lie side by side. Answers no where rounding could matter,
/// and for more than a dozen or so triangles. All triangles have the vertex as a corner.
[[nodiscard]] bool isSpreadFan(const TriangleMesh& mesh, std::uint32_t vertex,
                               std::span<const std::uint32_t> triangles);

} // namespace frostfill
