// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace frostfill
{

/// What went wrong, with the value that the command line returns to the shell.
enum class ErrorCode : int
{
    thresholdFailed = 2, ///< a comparison, verdict or threshold failed
    usage = 64,          ///< the caller asked for something that makes no sense
    badData = 65,        ///< a mesh or scene that cannot be used
    inputMissing = 66,   ///< an input file does not exist or cannot be read
    noOpenGl = 69,       ///< no OpenGL context is to be had
    missingProgram = 69, ///< a program that is needed, such as gnuplot, is not installed
    postcondition = 70,  ///< NaN, a centre outside the mesh, a blank frame
    outOfMemory = 71,
    cannotCreate = 73, ///< an output file or directory cannot be created
    writeFailed = 74,  ///< writing failed half-way, for instance on a full disk
    stoppedEarly = 75, ///< stopped by a signal or a limit; what was written is intact
};

/// The only exception that leaves the library: one sentence that says what, where and what to do.
class Error : public std::runtime_error
{
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

} // namespace frostfill
