// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/contact_shadows.hpp"
#include "render/raster/spheres/ground_raster.hpp"

#include <glm/mat4x4.hpp>

namespace frostfill
{

/// Draws shadows of spheres on walls as contact.vert and contact.frag do: over what is there, once
/// for all samples of a pixel.
class ContactRaster
{
public:
    ContactRaster(const glm::mat4& view, const PixelGrid& grid, bool avx2)
        : view_(view), grid_(grid), avx2_(avx2)
    {
    }

    /// Draws to a whole tile.
    void draw(const ContactShadows::Seen& seen, const TilePart& whole,
              TileBackground& pixels) const;

private:
    glm::mat4 view_;
    PixelGrid grid_;
    bool avx2_;
};

} // namespace frostfill
