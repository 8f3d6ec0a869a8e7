// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// 8-bit sRGB pixels, rows from top to bottom, no padding.
struct Image
{
    int width = 0;
    int height = 0;
    int channels = 3;                 ///< 3 (RGB), 4 (RGBA, straight alpha), or 2 (one 16-bit
                                      ///< value, high byte first)
    std::vector<std::uint8_t> pixels; ///< [height x width x channels]

    [[nodiscard]] const std::uint8_t* at(int x, int y) const
    {
        return pixels.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x)) *
                                   static_cast<std::size_t>(channels);
    }
};

/// How two pictures differ.
struct ImageDifference
{
    bool sameShape = false;      ///< width, height and channels agree; otherwise the rest is 0
    double rootMeanSquare = 0;   ///< over all channels, 0..255
    int largest = 0;             ///< largest difference of one channel, 0..255
    std::size_t pixelsApart = 0; ///< pixels with a channel that differs by more than 8
};
[[nodiscard]] ImageDifference compareImages(const Image& a, const Image& b);

/// Keyword and text of a PNG text chunk (Latin-1).
using PngText = std::vector<std::pair<std::string, std::string>>;

/// The bytes of a PNG file.
[[nodiscard]] std::vector<std::uint8_t> encodePng(const Image& image, const PngText& text = {});

/// Writes to a temporary name beside `file` and renames, so an incomplete picture never appears.
/// Throws Error cannotCreate or writeFailed.
void savePng(const Image& image, const std::filesystem::path& file, const PngText& text = {});

/// A destination of pictures, such as a sequence of files or a video.
class ImageSink
{
public:
    virtual ~ImageSink() = default;
    /// Takes frame `number`, counted from 0. Throws Error if it cannot be stored.
    virtual void put(std::size_t number, const Image& image) = 0;
};

} // namespace frostfill
#pragma GCC visibility pop
