// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

namespace frostfill
{

/// The bytes of a PNG file with 16-bit grey values, which stb_image_write has not: an Image of two
/// channels.
[[nodiscard]] std::vector<std::uint8_t> encodeGrey16(const Image& image);

} // namespace frostfill
