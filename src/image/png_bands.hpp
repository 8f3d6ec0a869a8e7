// SPDX-License-Identifier: MIT
// Room: pictures in memory: comparing, encoding, reading and writing PNG. Nothing here knows
// what a picture shows.
#pragma once

#include <frostfill/image.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Appends a deflate stream without an end, padded to a whole byte. Equal data gives equal bytes,
/// whatever the thread and wherever the memory lies. Throws Error outOfMemory.
void deflateBand(const std::vector<std::uint8_t>& data, std::vector<std::uint8_t>& out);

/// Encodes a sequence of pictures of one shape. Each picture is compressed in independent bands of
/// rows. Several threads can share the bands, and a band that equals that of the picture before is
/// not compressed again. The files are plain PNG and do not depend on which bands were reused.
class PngBands
{
public:
    /// `changedRows` [height] is not 0 for rows that may differ from the picture before; if it is
    /// empty, every row may differ. The bytes are valid until the next call.
    const std::vector<std::uint8_t>& encode(const Image& image, const PngText& text,
                                            std::span<const std::uint8_t> changedRows = {});

private:
    struct Band
    {
        std::vector<std::uint8_t> chunk; ///< IDAT with length and checksum
        std::uint32_t adler = 1;         ///< checksum of the uncompressed rows
        std::size_t size = 0;            ///< before compression [byte]
    };

    static void compress(const Image& image, std::size_t index, Band& band);

    int width_ = 0;
    int height_ = 0;
    int channels_ = 0;
    std::vector<Band> bands_;
    std::vector<std::size_t> wanted_; ///< bands that must be compressed
    std::vector<std::uint8_t> file_;
};

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
