// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// How another program ended.
struct ProgramRun
{
    int error = 0; ///< errno when it could not be started
    int code = 0;  ///< exit code, or 128 + the signal that ended it
    std::string said;
};

/// Runs a program, found in PATH by the first argument, in a folder, without input; waits for its
/// end and keeps what it writes to either output. It ends with this process, and inherits its open
/// files that are not marked to be closed.
[[nodiscard]] ProgramRun runProgram(const std::filesystem::path& folder,
                                    std::vector<std::string> arguments);

} // namespace frostfill
