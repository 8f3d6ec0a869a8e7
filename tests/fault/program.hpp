// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace frostfill::test
{

/// What the program answered.
struct Answer
{
    int code = 0; ///< exit code, or 128 + the signal that ended it
    std::string output;
    std::string errors;
};

/// Runs the frostfill program, or another, in `folder`; `arguments` is read by a shell and may
/// redirect. `environment` is put before the program, such as "PATH=/nowhere".
[[nodiscard]] Answer runProgram(const std::string& arguments, const std::string& folder,
                                const std::string& environment = "",
                                const std::string& program = FROSTFILL_PROGRAM);

} // namespace frostfill::test
