// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace frostfill
{

/// The scene with the keys of a scene file; null for a value that is not set.
[[nodiscard]] nlohmann::ordered_json sceneToJson(const Scene& scene);

/// Reads the output of sceneToJson. A key that is missing has its default: an earlier version did
/// not know it, and defaults keep what runs did before. Throws Error badData for a value that is
/// not allowed, and for keys that this version does not know.
[[nodiscard]] Scene sceneFromJson(const nlohmann::ordered_json& json,
                                  std::string_view nameForMessages);

/// Of all that a run follows from, the scene and the mesh, as 16 hex digits: known before its first
/// picture, and the same for a run that is repeated.
[[nodiscard]] std::string runHash(const Scene& scene, const TriangleMesh& mesh);

} // namespace frostfill
