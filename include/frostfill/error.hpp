// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What went wrong. The value is the exit code of the program.
enum class ErrorCode : int
{
    thresholdFailed = 2, ///< a comparison, verdict or threshold failed
    usage = 64,          ///< wrong use: an option, argument or call that makes no sense
    badData = 65,        ///< a mesh or scene that cannot be used
    inputMissing = 66,   ///< an input file does not exist or cannot be read
    noOpenGl = 69,       ///< no OpenGL context is available
    missingProgram = 69, ///< a required program, such as gnuplot, is not installed
    postcondition = 70,  ///< NaN, a centre outside the mesh, a blank frame
    outOfMemory = 71,
    cannotCreate = 73, ///< an output file or directory cannot be created
    writeFailed = 74,  ///< writing failed, for instance on a full disk
    stoppedEarly = 75, ///< stopped by a signal or a limit; all files are complete
};

/// The only exception that leaves the library. Its one sentence says what went wrong, where, and
/// what to do.
class Error : public std::runtime_error
{
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

} // namespace frostfill
#pragma GCC visibility pop
