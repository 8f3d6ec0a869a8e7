// SPDX-License-Identifier: MIT
#pragma once

#include "fps/fps_study.hpp"
#include "fps/table.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// The tables of a measurement: the paper against ours, whole runs, and what became of the spheres.
[[nodiscard]] std::vector<Table> fpsTables(const FpsResult& result);

/// A row a set, every column.
[[nodiscard]] Table fpsSetTable(const FpsResult& result);

/// Everything, with the machine. `compareFps` reads it.
[[nodiscard]] nlohmann::ordered_json fpsJson(const FpsResult& result);

/// The machine and the settings, in two lines.
[[nodiscard]] std::string fpsCircumstances(const FpsResult& result);

} // namespace frostfill
