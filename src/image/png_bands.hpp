// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// A chunk of text as it stands in a PNG file. [PNG 3rd edition, 11.3.3.2]
[[nodiscard]] std::vector<std::uint8_t> pngTextChunk(std::string_view keyword,
                                                     std::string_view text);

/// Encodes pictures of one shape that follow each other. A picture is compressed in bands of rows
/// that know nothing of each other, so that several threads can share them and a band that is the
/// same as in the picture before is not compressed again. The files are plain PNG, and do not tell
/// which bands were kept.
class PngBands
{
public:
    /// With `reuse` off every band is compressed every time.
    explicit PngBands(bool reuse = true) : reuse_(reuse) {}

    /// `changedRows` [height] is not 0 for rows that may differ from the picture before; without it
    /// all may. The bytes are valid until the next call.
    const std::vector<std::uint8_t>& encode(const Image& image, const PngText& text,
                                            std::span<const std::uint8_t> changedRows = {});

private:
    struct Band
    {
        std::vector<std::uint8_t> chunk; ///< IDAT with length and checksum
        std::uint32_t adler = 1;         ///< of what was compressed
        std::size_t size = 0;            ///< before compression [byte]
    };

    static void compress(const Image& image, std::size_t index, Band& band);

    bool reuse_;
    int width_ = 0;
    int height_ = 0;
    int channels_ = 0;
    std::vector<Band> bands_;
    std::vector<std::size_t> wanted_; ///< bands to be compressed
    std::vector<std::uint8_t> file_;
};

} // namespace frostfill
