// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/studio.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>

namespace frostfill
{

/// The pixels of a tile, rows upwards.
using TileBackground = std::array<std::uint32_t, kTilePixels>;

/// Draws the shadow on the ground as ground.vert and ground.frag do: over the background, whatever
/// its depth, once for all samples of a pixel.
class GroundRaster
{
public:
    /// `ground` has a shadow, and must stay.
    GroundRaster(const GroundShadow& ground, const glm::mat4& view, const PixelGrid& grid,
                 const Colour& background);

    /// Draws a whole tile. Returns whether any shadow is seen in it.
    bool draw(const TilePart& whole, TileBackground& pixels) const;

private:
    /// At a place of the picture [pixel]; 0 where the ground is not seen.
    [[nodiscard]] float darknessAt(float x, float y) const;
    [[nodiscard]] std::uint32_t blended(float dark) const;

    const GroundShadow& ground_;
    PixelGrid grid_;
    glm::vec4 background_; ///< premultiplied [0..1]
    // In eye space: a corner of the ground, its normal, and what gives a place on it in cells.
    glm::vec3 corner_, normal_, perAcross_, perAlong_;
};

} // namespace frostfill
