// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <nlohmann/json.hpp>

namespace frostfill
{

/// The scene with the keys of a scene file; null for a value that is not set.
[[nodiscard]] nlohmann::ordered_json sceneToJson(const Scene& scene);

/// Reads the output of sceneToJson. A key that is missing has its default: an earlier version did
/// not know it, and defaults keep what runs did before. Throws Error badData for a value that is
/// not allowed, and for keys that this version does not know.
[[nodiscard]] Scene sceneFromJson(const nlohmann::ordered_json& json,
                                  std::string_view nameForMessages);

} // namespace frostfill
