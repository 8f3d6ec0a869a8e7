// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace frostfill
{

/// Writes to a temporary name beside `file` and renames, so an incomplete file never appears.
/// Throws Error cannotCreate or writeFailed.
void saveBytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& file);

} // namespace frostfill
