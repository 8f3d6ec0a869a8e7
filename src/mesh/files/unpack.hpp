// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace frostfill
{

[[nodiscard]] inline bool isGzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

/// Returns the content of a gzip file, of one member or several. Throws Unreadable for damaged
/// data, and for more than 256 times its size.
[[nodiscard]] std::string gunzip(std::string_view packed);

/// Appends the `size` bytes of a zlib stream. Throws Unreadable as gunzip does, and for another
/// size.
void appendInflated(std::string_view packed, std::size_t size, std::string& to);

/// Returns the size of a file's content [byte], as a gzip file tells it: at most 16 times that of
/// the file, because files may lie. 0 for no file.
[[nodiscard]] std::size_t contentSize(const std::filesystem::path& file);

} // namespace frostfill
