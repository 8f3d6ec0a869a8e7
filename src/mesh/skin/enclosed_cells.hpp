// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <vector>

namespace frostfill
{

/// Whether there is room that a ball of radius alpha cannot get to from outside, roughly: cubes of
/// edge alpha away from all triangles that no path of such cubes connects with the outside. Then a
/// skin encloses more than itself. Rooms of less than some three alpha go unseen.
/// False where the cubes would be too many to look at.
[[nodiscard]] bool enclosesRoom(const TriangleMesh& mesh, double alpha);

/// [#T] Which triangles face a room that the surface mostly encloses, closed or open, such as the
/// inside of a cup. False for all where that would take too long.
[[nodiscard]] std::vector<bool> facesRooms(const TriangleMesh& mesh);

} // namespace frostfill
