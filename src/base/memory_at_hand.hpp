// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace frostfill
{

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
