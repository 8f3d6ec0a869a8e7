// SPDX-License-Identifier: MIT
#pragma once

#include "app/help/command_text.hpp"

#include <string>
#include <vector>

namespace frostfill
{

/// A script that teaches bash the commands, their options, and the words that these take. Files are
/// completed where nothing else is known.
[[nodiscard]] std::string bashCompletion(const std::vector<CommandText>& commands);

} // namespace frostfill
