// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/sample_tile.hpp"

#include <frostfill/view.hpp>

#include <algorithm>
#include <cstddef>

namespace frostfill
{

/// The tiles of a picture, row by row from the lower left corner. Those at the upper and right edge
/// reach beyond it.
class TileGrid
{
public:
    explicit TileGrid(const PictureSize& size)
        : size_(size), columns_((size.width + kTileEdge - 1) / kTileEdge),
          rows_((size.height + kTileEdge - 1) / kTileEdge)
    {
    }

    [[nodiscard]] std::size_t count() const { return at(0, rows_); }
    [[nodiscard]] int column(std::size_t tile) const { return static_cast<int>(tile) % columns_; }
    [[nodiscard]] int row(std::size_t tile) const { return static_cast<int>(tile) / columns_; }
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
                std::min(part.left + pixels.right, size_.width),
                std::min(part.bottom + pixels.top, size_.height)};
    }
    /// Calls visit(index of the tile) for those that a rectangle of the picture touches.
    template <typename Visit>
    void each(const PixelRectangle& pixels, Visit visit) const
    {
        const PixelRectangle inside = common(pixels, {0, 0, size_.width, size_.height});
        if (inside.empty())
        {
            return;
        }
        for (int y = inside.bottom / kTileEdge; y <= (inside.top - 1) / kTileEdge; ++y)
        {
            for (int x = inside.left / kTileEdge; x <= (inside.right - 1) / kTileEdge; ++x)
            {
                visit(at(x, y));
            }
        }
    }

private:
    [[nodiscard]] std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    PictureSize size_;
    int columns_;
    int rows_;
};

} // namespace frostfill
