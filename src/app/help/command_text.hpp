// SPDX-License-Identifier: MIT
// Room: the parser's own tables of commands and options, as texts and as a completion.
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// An option as the completion and docs/options.md show it.
struct OptionText
{
    std::vector<std::string> names; ///< "--lid", "--no-lid"; the name of a positional one
    std::string value;              ///< what follows it: "X", "fast|paper"; empty for a flag
    std::string help;
    std::vector<std::string> choices; ///< words that are allowed as the value
    bool positional = false;
};

/// A command, with those inside it: "bench error".
struct CommandText
{
    std::string name; ///< without that of the program
    std::vector<OptionText> options;
};

/// Every command of the program in the order of its help. Everything is read from the parser, whose
/// options come from the option table, so that nothing is listed twice.
[[nodiscard]] std::vector<CommandText> commandTexts(const CLI::App& program);

} // namespace frostfill
