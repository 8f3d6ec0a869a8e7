// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

namespace frostfill
{

/// The name of picture `index`.
using PictureName = std::function<std::string(std::size_t index)>;

/// Keeps every second of the `count` numbered pictures of a folder, the first among them, and
/// renumbers them. Whoever looks at the folder in the meantime, or after the process was killed,
/// finds all of them or the half, never some of each: the half is put together in FOLDER.part,
/// which then changes places with the folder. Where the file system knows no hard links, or the
/// folder is a symbolic link, they are renamed one by one instead. Other files in the folder stay
/// in it.
std::error_code keepEverySecond(const std::filesystem::path& folder, std::size_t count,
                                const PictureName& name);

} // namespace frostfill
