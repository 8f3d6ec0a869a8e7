// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Takes down what is blended over the samples of a tile, in its order.
class ShellRecord
{
public:
    /// What more is blended over one sample is not kept.
    static constexpr std::size_t kDeepest = 32;

    ShellRecord() : layers_(kDeepest) {}

    void clear();
    /// Over kLanes samples in a plane from `at` on. Premultiplied colours, 0 for none.
    void add(std::size_t plane, std::size_t at, const std::array<float, kLanes>& inverseDepth,
             const std::array<std::uint32_t, kLanes>& colour);
    /// Over one sample.
    void add(std::size_t plane, std::size_t at, float inverseDepth, std::uint32_t colour);
    /// Whether anything was not kept.
    [[nodiscard]] bool overflowed() const { return overflowed_; }

private:
    friend class ShellLayers;

    std::array<std::array<std::uint8_t, kTilePixels>, kMaxTileSamples> depths_{};
    std::vector<SampleTile> layers_; ///< the first surfaces over each sample, the second and so on
    bool overflowed_ = false;
};

/// The shell over a tile while neither it nor the camera changes: blending it takes as long as what
/// it shows, however many triangles that was.
class ShellLayers
{
public:
    /// `planes` of samples. Nothing may be missing in the record.
    ShellLayers(const ShellRecord& record, std::size_t planes);

    /// Where it is before what is there. `avx2` as lanes::hasAvx2().
    void blend(bool avx2, const PixelRectangle& pixels, SampleTile& tile) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Pixels of a row, one sample each.
    struct Piece
    {
        std::array<float, kLanes> inverseDepth;
        std::array<std::uint32_t, kLanes> colour;
    };
    static constexpr std::size_t kGroups = kTilePixels / kLanes;

    template <class Tile>
    void blendAny(const PixelRectangle& pixels, Tile& tile) const;
    void blendAvx2(const PixelRectangle& pixels, SampleTile& tile) const;
    void blendPlain(const PixelRectangle& pixels, SampleTile& tile) const;

    std::size_t planes_;
    std::vector<std::uint32_t> starts_; ///< [kGroups * planes + 1] into pieces_
    std::vector<Piece> pieces_;
};

} // namespace frostfill
