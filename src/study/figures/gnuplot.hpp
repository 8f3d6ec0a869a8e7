// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace frostfill
{

/// Throws Error missingProgram, with what installs it, when gnuplot cannot be run.
void requireGnuplot();

/// Runs a script in its folder, with the variable `format` set to "svg" or "png". Throws Error
/// missingProgram, or writeFailed with gnuplot's own message when it fails.
void runGnuplot(const std::filesystem::path& folder, const std::string& script,
                const std::string& format);

} // namespace frostfill
