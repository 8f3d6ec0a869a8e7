// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/walls.hpp"

namespace frostfill
{

/// The public inspectInterior, for who knows the walls already.
[[nodiscard]] MeshReport inspectInterior(const TriangleMesh& mesh, const Walls& walls);

} // namespace frostfill
