// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

#include <filesystem>

namespace frostfill
{

/// Reads a picture by stb_image, which shares no code with what wrote it: grey becomes RGB. Throws
/// std::runtime_error for what is no whole PNG.
[[nodiscard]] Image loadPng(const std::filesystem::path& file);

} // namespace frostfill
