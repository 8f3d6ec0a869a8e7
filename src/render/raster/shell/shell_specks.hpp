// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_layers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace frostfill
{

/// A triangle of which only few columns and rows of pixels have a sample, and that shows no line
/// but the outline of a smooth surface. Colour and depth change evenly over it, the colour from
/// pixel to pixel.
struct ShellSpeck
{
    static constexpr int kEdge = 4;     ///< at most so many columns and rows
    static constexpr int kFraction = 5; ///< bits of a colour below 1

    /// A bit for each sample, kMaxTileSamples a pixel, kEdge pixels a row, from its lowest left.
    std::uint64_t covered;
    float inverseDepth; ///< in the middle of the first pixel
    float depthAcross;  ///< added a pixel further
    float depthUpwards;
    using Channels = std::array<std::int16_t, 4>; ///< premultiplied
    Channels colour;                              ///< in the middle of the first pixel
    Channels colourAcross;                        ///< added a pixel further
    Channels colourUpwards;
};

/// Blends a speck that lies in `own` [pixel of the tile] over those in `pixels`, a part of it.
void drawSpeck(bool avx2, const ShellSpeck& speck, const PixelRectangle& own,
               const PixelRectangle& pixels, SampleTile& tile);
/// The same, taken down as over a tile in which nothing lies.
void drawSpeck(bool avx2, const ShellSpeck& speck, const PixelRectangle& own,
               const PixelRectangle& pixels, ShellRecord& record);

} // namespace frostfill
