// SPDX-License-Identifier: MIT
#include "render/raster/lanes/sample_tile.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

using Row = std::array<std::uint32_t, kTileEdge>;

void meanOfFour(const SampleTile& tile, int first, int count, Row& mean)
{
    for (int x = 0; x < count; ++x)
    {
        // Two channels at once.
        std::uint32_t redBlue = 0x00020002U;
        std::uint32_t greenAlpha = 0x00020002U;
        for (const auto& plane : tile.colour)
        {
            const std::uint32_t colour =
                plane[static_cast<std::size_t>(first) + static_cast<std::size_t>(x)];
            redBlue += colour & 0x00ff00ffU;
            greenAlpha += (colour >> 8) & 0x00ff00ffU;
        }
        mean[static_cast<std::size_t>(x)] =
            ((redBlue >> 2) & 0x00ff00ffU) | ((greenAlpha >> 2) & 0x00ff00ffU) << 8;
    }
}

} // namespace

void resolve(const SampleTile& tile, const TilePart& part, int samples, Image& image)
{
    // Tiles and lanes may reach beyond the picture.
    const PixelRectangle& pixels = part.pixels;
    const int count = std::min(pixels.width(), image.width - part.left - pixels.left);
    Row row;
    for (int y = pixels.bottom; y < std::min(pixels.top, image.height - part.bottom); ++y)
    {
        const int first = y * kTileEdge + pixels.left;
        if (samples > 1)
        {
            meanOfFour(tile, first, count, row);
        }
        else
        {
            std::copy_n(tile.colour[0].begin() + first, count, row.begin());
        }
        const auto at = (static_cast<std::size_t>(image.height - 1 - part.bottom - y) *
                             static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(part.left + pixels.left)) *
                        static_cast<std::size_t>(image.channels);
        writePixels(reinterpret_cast<const std::uint8_t*>(row.data()), count, image.channels,
                    image.pixels.data() + at);
    }
}

} // namespace frostfill
