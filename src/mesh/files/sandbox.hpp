// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// What a child process may use.
struct SandboxLimits
{
    std::size_t bytes = std::size_t{1} << 30; ///< of address space, beyond what the parent has
    unsigned seconds = 30;                    ///< of processor time
};

/// Bytes that nobody has set to anything before.
struct SandboxedBytes
{
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;

    [[nodiscard]] std::string_view view() const { return {bytes.get(), size}; }
};

/// What a child process sends one after the other, without a copy. It lies in what outlives `work`,
/// such as a variable of the caller, which the child has a copy of.
using SandboxReport = std::vector<std::string_view>;

/// Runs `work` in a child process and returns the bytes that it returns. Whatever happens there, a
/// crash, an endless loop, memory without end, stays there. The child opens at most a few files at
/// a time and writes to none, leaves no core, and dies with its parent.
///
/// In a process with several threads, such as Python's, the child could hang: there `work` runs in
/// this process, without limits.
///
/// Throws Error as `work` throws it, and badData when the child dies or exceeds a limit; `subject`
/// begins those sentences: "'a.ply' cannot be read".
[[nodiscard]] SandboxedBytes runSandboxed(const SandboxLimits& limits, const std::string& subject,
                                          const std::function<SandboxReport()>& work);

} // namespace frostfill
