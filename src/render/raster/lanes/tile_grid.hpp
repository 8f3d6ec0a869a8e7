// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"

#include <frostfill/view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The tiles of a picture, row by row from the lower left corner. Those at the upper and right edge
/// reach beyond it.
class TileGrid
{
public:
    explicit TileGrid(const PictureSize& size)
        : picture_{0, 0, size.width, size.height},
          columns_((size.width + kTileEdge - 1) / kTileEdge),
          rows_((size.height + kTileEdge - 1) / kTileEdge)
    {
    }

    [[nodiscard]] std::size_t count() const { return at(0, rows_); }
    [[nodiscard]] int column(std::size_t tile) const { return static_cast<int>(tile) % columns_; }
    [[nodiscard]] int row(std::size_t tile) const { return static_cast<int>(tile) / columns_; }

    /// Calls visit(index of the tile) for those that a rectangle of the picture touches.
    template <typename Visit>
    void each(const PixelRectangle& pixels, Visit visit) const
    {
        const PixelRectangle inside = common(pixels, picture_);
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
                std::min(part.left + pixels.right, picture_.right),
                std::min(part.bottom + pixels.top, picture_.top)};
    }

private:
    [[nodiscard]] std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    PixelRectangle picture_;
    int columns_;
    int rows_;
};

/// Lists, for each tile of a picture, the things that may be visible in it.
class TileLists
{
public:
    explicit TileLists(const TileGrid& grid) : grid_(grid), things_(grid.count()) {}

    void clear()
    {
        for (std::vector<std::uint32_t>& things : things_)
        {
            things.clear();
        }
    }
    /// Things keep the order in which they are listed. `bounds` are around it in the picture.
    void list(std::uint32_t thing, const PixelRectangle& bounds)
    {
        grid_.each(bounds, [&](std::size_t tile) { things_[tile].push_back(thing); });
    }

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t tile) const
    {
        return things_[tile];
    }

private:
    TileGrid grid_;
    std::vector<std::vector<std::uint32_t>> things_; ///< [tiles]; memory stays
};

} // namespace frostfill
