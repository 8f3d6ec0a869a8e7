// SPDX-License-Identifier: MIT
// Room: what all that is drawn without OpenGL is drawn with: several pixels at once, the shaders'
// text for them, and tiles of samples that stay in the processor's cache.
#pragma once

#include "render/framing/pixel_rectangle.hpp"

#include <frostfill/image.hpp>
#include <frostfill/view.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// Edge of a tile [pixel].
inline constexpr int kTileEdge = 32;
inline constexpr int kTilePixels = kTileEdge * kTileEdge;

/// Pixels of a row that are worked out at once: as many floats as a register of AVX2 has. Parts of
/// tiles begin and end at multiples of it.
inline constexpr int kLanes = 8;

inline constexpr int kMaxTileSamples = 4;

/// Whether tiles are drawn with AVX2, which gives the same bits as drawing without: tests compare
/// both.
#if defined(__x86_64__)
inline bool drawsWithAvx2 = __builtin_cpu_supports("avx2") != 0;
#else
inline bool drawsWithAvx2 = false;
#endif

/// How near a surface is: 1 over the distance ahead of the eye, or without perspective its height
/// above the eye's plane; it is linear over the picture. Larger hides smaller, nothing hides least.
inline constexpr float kNothing = std::numeric_limits<float>::lowest();

/// In the order of SampleTile's bytes.
[[nodiscard]] inline std::uint32_t premultiplied(const Colour& colour)
{
    std::uint32_t word = std::uint32_t{colour[3]} << 24;
    for (std::size_t c = 0; c < 3; ++c)
    {
        word |= ((std::uint32_t{colour[c]} * colour[3] + 127) / 255) << (8 * c);
    }
    return word;
}

/// The samples of a tile, a plane for each sample of a pixel; rows upwards. Colours are
/// premultiplied RGBA with red in the lowest byte.
struct SampleTile
{
    alignas(64) std::array<std::array<float, kTilePixels>, kMaxTileSamples> inverseDepth;
    alignas(64) std::array<std::array<std::uint32_t, kTilePixels>, kMaxTileSamples> colour;
};

/// A sample's place from the middle of its pixel [pixel], y upwards.
struct SampleOffset
{
    float x = 0;
    float y = 0;
};

/// Those of Mesa.
inline constexpr std::array<SampleOffset, kMaxTileSamples> kFourSamples = {
    {{-0.125F, -0.375F}, {0.375F, -0.125F}, {-0.375F, 0.125F}, {0.125F, 0.375F}}};

/// Widened so that left and right are multiples of kLanes.
[[nodiscard]] inline PixelRectangle inWholeLanes(const PixelRectangle& pixels)
{
    return pixels.empty() ? PixelRectangle{}
                          : PixelRectangle{pixels.left & ~(kLanes - 1), pixels.bottom,
                                           (pixels.right + kLanes - 1) & ~(kLanes - 1), pixels.top};
}

/// Where in the picture a tile lies, and the part of it that is drawn to.
struct TilePart
{
    int left = 0;          ///< of the tile [pixel]
    int bottom = 0;        ///< of the tile [pixel]
    PixelRectangle pixels; ///< in the tile; left and right are multiples of kLanes

    /// A rectangle of the picture in this part.
    [[nodiscard]] PixelRectangle inside(const PixelRectangle& picture) const
    {
        return common(inTile(picture), pixels);
    }
    /// The same, from the tile's corner.
    [[nodiscard]] PixelRectangle inTile(const PixelRectangle& picture) const
    {
        return {picture.left - left, picture.bottom - bottom, picture.right - left,
                picture.top - bottom};
    }
    /// The same, widened to whole lanes.
    [[nodiscard]] PixelRectangle within(const PixelRectangle& picture) const
    {
        return inWholeLanes(inside(picture));
    }
};

/// Writes the means of the samples of a part of a tile into the picture, which has three channels,
/// or four: then colours are divided by alpha. The picture's top row is first.
void resolve(const SampleTile& tile, const TilePart& part, int samples, Image& image);

/// For each tile of a picture the things that may be visible in it.
using TileLists = std::vector<std::vector<std::uint32_t>>;

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

    /// Appends a thing to the lists of the tiles [count()] that its bounds touch.
    void list(std::uint32_t thing, const PixelRectangle& bounds, TileLists& lists) const
    {
        each(bounds, [&](std::size_t tile) { lists[tile].push_back(thing); });
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

} // namespace frostfill
