// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"

#include <frostfill/view.hpp>

#include <algorithm>
#include <cstddef>

namespace frostfill
{

/// The tiles of a picture, with room for samples.
class TileGrid : public TilePlaces
{
public:
    using TilePlaces::TilePlaces;

    /// All of a tile.
    [[nodiscard]] TilePart part(std::size_t tile) const
    {
        return {column(tile) * kTileEdge, row(tile) * kTileEdge, {0, 0, kTileEdge, kTileEdge}};
    }
    /// A part of a tile, in the picture; empty if it lies beyond it.
    [[nodiscard]] PixelRectangle inPicture(const TilePart& part) const
    {
        const PixelRectangle& pixels = part.pixels;
        return {part.left + pixels.left, part.bottom + pixels.bottom,
                std::min(part.left + pixels.right, picture().right),
                std::min(part.bottom + pixels.top, picture().top)};
    }
};

} // namespace frostfill
