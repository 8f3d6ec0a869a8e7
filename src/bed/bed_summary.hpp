// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed_surface.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace frostfill
{

/// What stands beside geometry: spheres, treatment, porosity.
[[nodiscard]] nlohmann::ordered_json bedSummary(const Bed& bed);
/// And of a surface: triangles, what has become of contacts, its porosity beside the exact one.
[[nodiscard]] nlohmann::ordered_json surfaceSummary(const BedSurface& surface);
void writeSummary(const nlohmann::ordered_json& summary, const std::filesystem::path& file);

} // namespace frostfill
