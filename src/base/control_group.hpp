// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The folders of the control groups that hold this process, from the innermost to the root: of
/// version 2, and of version 1 for a controller such as "memory". A container may see only some of
/// these folders, so each may be missing. `root` is where `proc` and `sys` are.
[[nodiscard]] std::vector<std::filesystem::path>
controlGroups(std::string_view controller, const std::filesystem::path& root = "/");

} // namespace frostfill
