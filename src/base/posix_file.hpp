// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace frostfill
{

// Files written by system calls instead of streams: a call that a signal interrupts is repeated,
// a short write goes on, and what the disk refuses is known at the call that it refuses.

/// Creates a file, which must not be there yet. Returns a descriptor, or -1 with errno.
[[nodiscard]] int createNewFile(const std::filesystem::path& file);

/// Each returns an error number, 0 for none.
[[nodiscard]] int writeAll(int descriptor, std::span<const std::uint8_t> bytes);
/// Waits until the content is on the disk. File systems that cannot wait are no error.
[[nodiscard]] int syncFile(int descriptor);
[[nodiscard]] int closeFile(int descriptor);

/// Waits until all that was written to the file system of `directory` is on the disk.
[[nodiscard]] int syncFileSystem(const std::filesystem::path& directory);

/// Why `file` could not be written, in a sentence; on a full disk with what it needs at least and
/// what is free.
[[nodiscard]] std::string writeFailure(const std::filesystem::path& file, int error,
                                       std::size_t bytes);

} // namespace frostfill
