// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>

namespace frostfill
{

/// What a PNG file says of itself, without its pixels.
struct PngFacts
{
    int width = 0;
    int height = 0;
    PngText text;                ///< in the order of the file
    std::size_t packedBytes = 0; ///< of the pixels
};

/// Reads all of the file and checks the sum of each chunk. Empty for a file that is missing, is no
/// PNG, is damaged or does not end where it should. [PNG 3rd edition, 5]
[[nodiscard]] std::optional<PngFacts> pngFacts(const std::filesystem::path& file);

} // namespace frostfill
