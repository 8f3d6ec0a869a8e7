// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"

#include <frostfill/view.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
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
    /// boundsOf(thing) is around it in the picture; things keep their order.
    template <typename BoundsOf>
    TileLists(const TilePlaces& places, std::span<const std::uint32_t> things, BoundsOf boundsOf)
        : starts_(places.count() + 1, 0)
    {
        for (const std::uint32_t thing : things)
        {
            places.each(boundsOf(thing), [&](std::size_t tile) { ++starts_[tile + 1]; });
        }
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        things_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (const std::uint32_t thing : things)
        {
            places.each(boundsOf(thing), [&](std::size_t tile) { things_[next[tile]++] = thing; });
        }
    }

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t tile) const
    {
        return std::span(things_).subspan(starts_[tile], starts_[tile + 1] - starts_[tile]);
    }

private:
    std::vector<std::uint32_t> starts_; ///< [tiles + 1] into things_
    std::vector<std::uint32_t> things_; ///< of a tile after those of the tile before
};

} // namespace frostfill
