// SPDX-License-Identifier: MIT
#pragma once

#include "app/help/command_text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

/// Manual pages, in the macros of man(7), by the names of their files: frostfill.1 and one for each
/// command, such as frostfill-fill.1 and frostfill-bench-error.1.
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
manPages(const std::vector<CommandText>& commands, const std::string& footer);

} // namespace frostfill
