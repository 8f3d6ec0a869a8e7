// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace frostfill
{

/// What a child process may use.
struct SandboxLimits
{
    std::size_t bytes = std::size_t{1} << 30; ///< of address space, beyond what the parent has
    unsigned seconds = 30;                    ///< of processor time
};

/// What a reader returns.
struct ReadResult
{
    TriangleMesh mesh;
    std::string remarks; ///< a line each
    std::string patches; ///< by turns a line with a name, and one with a number of triangles
};

/// Runs `work` in a child process and returns its result. Whatever happens there, a crash, an
/// endless loop, memory without end, stays there. The child opens at most a few files at a time and
/// writes to none, leaves no core, and dies with its parent.
///
/// In a process with several threads, such as Python's, the child could hang: there `work` runs in
/// this process, without limits.
///
/// Throws Error as `work` throws it, and badData when the child dies or exceeds a limit; `subject`
/// begins those sentences: "'a.ply' cannot be read".
[[nodiscard]] ReadResult runSandboxed(const SandboxLimits& limits, const std::string& subject,
                                      const std::function<ReadResult()>& work);

} // namespace frostfill
