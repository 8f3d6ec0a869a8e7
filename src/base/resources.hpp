// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

// FROSTFILL_SANITIZED is defined in a build for a sanitizer, which maps terabytes of address space,
// has an allocator of its own, and cannot be preloaded around. GCC and Clang tell it differently.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FROSTFILL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FROSTFILL_SANITIZED
#endif
#endif

namespace frostfill
{

/// Returns how many cores this process may use, at least 1: the smallest of the machine's cores,
/// the cores it is bound to, the quota of its control group, and the cores that Slurm gives to its
/// task.
[[nodiscard]] int coresAtHand();

/// Memory that this process may have, and what bounds it.
struct MemoryAtHand
{
    double bytes = 0;
    std::string bound = "here"; ///< in words, behind "the 2 GB of memory"
};

/// The least of the machine's memory, the limit on the address space, and what is left of the
/// limits of the control groups. Files in the cache of a group count as free. `root` is where
/// `proc` and `sys` are.
[[nodiscard]] MemoryAtHand memoryAtHand(const std::filesystem::path& root = "/");

/// Whether the process may still map so much: a limit on its address space leaves it.
[[nodiscard]] bool mayMap(std::size_t bytes);

} // namespace frostfill
