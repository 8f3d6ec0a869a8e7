// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_layers.hpp"

#include "render/raster/lanes/lanes.hpp"

#include <algorithm>

namespace frostfill
{

using namespace lanes;

void ShellRecord::clear()
{
    for (auto& plane : depths_)
    {
        plane.fill(0);
    }
    overflowed_ = false;
}

void ShellRecord::add(std::size_t plane, std::size_t at,
                      const std::array<float, kLanes>& inverseDepth,
                      const std::array<std::uint32_t, kLanes>& colour)
{
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        add(plane, at + lane, inverseDepth[lane], colour[lane]);
    }
}

void ShellRecord::add(std::size_t plane, std::size_t at, float inverseDepth, std::uint32_t colour)
{
    if (colour == 0) // leaves what is below as it is
    {
        return;
    }
    std::uint8_t& depth = depths_[plane][at];
    if (depth == kDeepest)
    {
        overflowed_ = true;
        return;
    }
    layers_[depth].inverseDepth[plane][at] = inverseDepth;
    layers_[depth].colour[plane][at] = colour;
    ++depth;
}

ShellLayers::ShellLayers(const ShellRecord& record, std::size_t planes) : planes_(planes)
{
    const auto depthAt = [&](std::size_t plane, std::size_t first)
    {
        const auto from = record.depths_[plane].begin() + static_cast<std::ptrdiff_t>(first);
        return std::size_t{*std::max_element(from, from + kLanes)};
    };
    starts_.reserve(kGroups * planes + 1);
    std::size_t count = 0;
    for (std::size_t group = 0; group < kGroups; ++group)
    {
        for (std::size_t plane = 0; plane < planes; ++plane)
        {
            starts_.push_back(static_cast<std::uint32_t>(count));
            count += depthAt(plane, group * kLanes);
        }
    }
    starts_.push_back(static_cast<std::uint32_t>(count));
    pieces_.reserve(count);
    for (std::size_t i = 0; i + 1 < starts_.size(); ++i)
    {
        const std::size_t plane = i % planes;
        const std::size_t first = i / planes * kLanes;
        for (std::size_t n = 0; n < starts_[i + 1] - starts_[i]; ++n)
        {
            Piece& piece = pieces_.emplace_back();
            for (std::size_t lane = 0; lane < kLanes; ++lane)
            {
                const std::size_t at = first + lane;
                const bool covered = n < record.depths_[plane][at];
                const SampleTile& layer = record.layers_[n];
                piece.inverseDepth[lane] = covered ? layer.inverseDepth[plane][at] : kNothing;
                piece.colour[lane] = covered ? layer.colour[plane][at] : 0;
            }
        }
    }
}

template <class Tile>
FROSTFILL_INLINE void ShellLayers::blendAny(const PixelRectangle& pixels, Tile& tile) const
{
    for (int y = pixels.bottom; y < pixels.top; ++y)
    {
        for (int x = pixels.left; x < pixels.right; x += kLanes)
        {
            const int pixel = y * kTileEdge + x;
            const auto at = static_cast<std::size_t>(pixel);
            for (std::size_t plane = 0; plane < planes_; ++plane)
            {
                const std::size_t group = at / kLanes * planes_ + plane;
                const Piece* piece = pieces_.data() + starts_[group];
                const Piece* const end = pieces_.data() + starts_[group + 1];
                if (piece == end)
                {
                    continue;
                }
                const auto below = load<Floats>(tile.inverseDepth[plane].data() + at);
                auto colour = load<Words>(tile.colour[plane].data() + at);
                for (; piece != end; ++piece)
                {
                    const Mask seen = load<Floats>(piece->inverseDepth.data()) > below;
                    colour = blended(
                        load<Words>(piece->colour.data()) & reinterpret_cast<Words>(seen), colour);
                }
                store(colour, tile.colour[plane].data() + at);
            }
        }
    }
}

FROSTFILL_AVX2 void ShellLayers::blendAvx2(const PixelRectangle& pixels, SampleTile& tile) const
{
    blendAny(pixels, tile);
}

void ShellLayers::blendPlain(const PixelRectangle& pixels, SampleTile& tile) const
{
    blendAny(pixels, tile);
}

void ShellLayers::blend(bool avx2, const PixelRectangle& pixels, SampleTile& tile) const
{
    avx2 ? blendAvx2(pixels, tile) : blendPlain(pixels, tile);
}

std::size_t ShellLayers::bytes() const
{
    return pieces_.capacity() * sizeof(Piece) + starts_.capacity() * sizeof(starts_[0]);
}

} // namespace frostfill
