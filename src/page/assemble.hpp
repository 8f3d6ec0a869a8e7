// SPDX-License-Identifier: MIT
#pragma once

#include "page/sections.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace frostfill
{

/// The whole page: the files of page/ and the shaders, what is to be shown, and its facts. Adds to
/// the facts where each section begins.
[[nodiscard]] std::string assemblePage(nlohmann::ordered_json facts, const Sections& sections);

} // namespace frostfill
