// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace frostfill
{

/// Every setting of a scene as Markdown, from the table of options: a heading for each group, and
/// below it a table with the option, the key in scene files, the values, the default and the help.
[[nodiscard]] std::string sceneOptionsMarkdown();

/// Whether a flag of the command line, such as "--radius", belongs to that table.
[[nodiscard]] bool isSceneOption(std::string_view flag);

} // namespace frostfill
