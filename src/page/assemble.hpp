// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace frostfill
{

/// What a page has beside its facts: named runs of bytes, which page/data.js takes apart again.
using Sections = std::vector<std::pair<std::string, std::string>>;

/// All bytes of the sections one after another, as one zlib stream in base64.
[[nodiscard]] std::string packedText(const Sections& sections);

[[nodiscard]] std::string base64(std::string_view bytes);

/// The whole page: the files of page/ and the shaders, what is to be shown, and its facts. Adds to
/// the facts where each section begins.
[[nodiscard]] std::string assemblePage(nlohmann::ordered_json facts, const Sections& sections);

} // namespace frostfill
