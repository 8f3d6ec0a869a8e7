// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <vector>

namespace frostfill
{

/// [#T] Which triangles face a room that the surface mostly encloses, closed or open, such as the
/// inside of a cup. False for all where that would take too long.
[[nodiscard]] std::vector<bool> facesRooms(const TriangleMesh& mesh);

} // namespace frostfill
