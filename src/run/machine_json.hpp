// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace frostfill
{

/// The computer, the build, the libraries and the renderer, as files tell them. `renderer` is empty
/// when nothing was drawn.
[[nodiscard]] nlohmann::ordered_json machineJson(const std::string& renderer);

} // namespace frostfill
