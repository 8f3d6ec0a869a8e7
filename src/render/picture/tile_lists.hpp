// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"

#include <frostfill/view.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The tiles of a picture, row by row from the lower left corner. Those at the upper and right edge
/// reach beyond it.
class TilePlaces
{
public:
    /// Edge of a tile. [pixel]
    static constexpr int kTile = 32;

    explicit TilePlaces(const PictureSize& size)
        : picture_{0, 0, size.width, size.height}, columns_((size.width + kTile - 1) / kTile),
          rows_((size.height + kTile - 1) / kTile)
    {
    }

    [[nodiscard]] std::size_t count() const { return at(0, rows_); }
    [[nodiscard]] int column(std::size_t tile) const { return static_cast<int>(tile) % columns_; }
    [[nodiscard]] int row(std::size_t tile) const { return static_cast<int>(tile) / columns_; }
    [[nodiscard]] const PixelRectangle& picture() const { return picture_; }

    /// Calls visit(index of the tile) for those that a rectangle of the picture touches.
    template <typename Visit>
    void each(const PixelRectangle& pixels, Visit visit) const
    {
        const PixelRectangle inside = common(pixels, picture_);
        if (inside.empty())
        {
            return;
        }
        for (int y = inside.bottom / kTile; y <= (inside.top - 1) / kTile; ++y)
        {
            for (int x = inside.left / kTile; x <= (inside.right - 1) / kTile; ++x)
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

    PixelRectangle picture_;
    int columns_;
    int rows_;
};

/// What may be seen in each tile of a picture.
class TileLists
{
public:
    explicit TileLists(const TilePlaces& places) : places_(places), things_(places.count()) {}

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
        places_.each(bounds, [&](std::size_t tile) { things_[tile].push_back(thing); });
    }

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t tile) const
    {
        return things_[tile];
    }

private:
    TilePlaces places_;
    std::vector<std::vector<std::uint32_t>> things_; ///< [tiles]; memory stays
};

} // namespace frostfill
