// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <string>

namespace frostfill
{

/// Of all that a run follows from, the scene and the mesh, as 16 hex digits: known before its first
/// picture, and the same for a run that is repeated.
[[nodiscard]] std::string runHash(const Scene& scene, const TriangleMesh& mesh);

} // namespace frostfill
