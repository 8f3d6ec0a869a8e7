// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/walls.hpp"

namespace frostfill
{

/// The public inspectInterior, for who has the report of inspectMesh and the walls already. The
/// threads change no bit of it.
[[nodiscard]] MeshReport inspectInterior(const TriangleMesh& mesh, MeshReport report,
                                         const Walls& walls, Threads& threads);
/// inspectMesh, for who has the edges already.
[[nodiscard]] MeshReport inspectMesh(const TriangleMesh& mesh, const EdgeTable& edges);

} // namespace frostfill
