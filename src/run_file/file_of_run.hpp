// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace frostfill
{

/// The run file's name in the directory of a run.
inline constexpr const char* kRunFile = "run.frost";

/// The file of a run that is named by its file or its directory. Throws Error inputMissing.
[[nodiscard]] std::filesystem::path fileOfRun(const std::filesystem::path& run);

} // namespace frostfill
