// SPDX-License-Identifier: MIT
#include "render/raster/lanes/sample_tile.hpp"

#include <algorithm>
#include <cstring>

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

void writeOpaque(const Row& row, int count, std::uint8_t* to)
{
    // Four bytes at once; the next pixel overwrites the fourth, so the last takes three.
    for (int x = 0; x + 1 < count; ++x, to += 3)
    {
        std::memcpy(to, &row[static_cast<std::size_t>(x)], 4);
    }
    std::memcpy(to, &row[static_cast<std::size_t>(count - 1)], 3);
}

void writeStraight(const Row& row, int count, std::uint8_t* to)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t colour = row[static_cast<std::size_t>(x)];
        const std::uint32_t alpha = colour >> 24;
        for (int shift = 0; shift < 24; shift += 8)
        {
            const std::uint32_t channel = (colour >> shift) & 255;
            const std::uint32_t straight = alpha == 0 ? 0 : (channel * 255 + alpha / 2) / alpha;
            *to++ = static_cast<std::uint8_t>(std::min(straight, 255U));
        }
        *to++ = static_cast<std::uint8_t>(alpha);
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
        image.channels == 4 ? writeStraight(row, count, image.pixels.data() + at)
                            : writeOpaque(row, count, image.pixels.data() + at);
    }
}

} // namespace frostfill
