// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

/// Names and versions of the libraries that this program was built with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> libraryVersions();

} // namespace frostfill
