// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <string>

namespace frostfill
{

/// A line each for --lid, --wrap and --unite: what it would make of a mesh, in volume and surface.
/// Empty for a mesh that is closed and does not meet itself. `asRead` is its inspection.
[[nodiscard]] std::string loadEffectsText(const TriangleMesh& mesh, const MeshReport& asRead,
                                          const std::string& name);

} // namespace frostfill
