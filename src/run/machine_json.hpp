// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

/// Names and versions of the libraries that this program was built with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> libraryVersions();

/// The computer, the build, the libraries and the renderer, as files tell them. `renderer` is empty
/// when nothing was drawn.
[[nodiscard]] nlohmann::ordered_json machineJson(const std::string& renderer);

} // namespace frostfill
