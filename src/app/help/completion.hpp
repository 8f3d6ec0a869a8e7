// SPDX-License-Identifier: MIT
#pragma once

#include "app/help/command_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// Shells for which there is a completion.
[[nodiscard]] std::vector<std::string> shells();

/// A script that teaches the shell (bash, zsh or fish) the commands, their options, and the words
/// that these take. Files are completed where nothing else is known.
[[nodiscard]] std::string completionScript(std::string_view shell,
                                           const std::vector<CommandText>& commands);

} // namespace frostfill
