// SPDX-License-Identifier: MIT
#include "render/raster/spheres/contact_raster.hpp"

#include "render/raster/lanes/shading.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace frostfill
{
namespace
{

using namespace lanes;

/// One shadow in eye space.
struct DrawnContact
{
    const ContactShadow& shadow;
    const PixelGrid& grid;
    glm::vec3 foot, across, along, inwards; ///< the two axes over the sphere's radius squared
};

FROSTFILL_INLINE Words contactAt(const DrawnContact& c, Floats x, float y)
{
    const Floats seenX = c.grid.left + c.grid.perColumn * x;
    const float seenY = c.grid.bottom + c.grid.perRow * y;
    Floats way;
    Vectors point;
    if (c.grid.orthographic)
    {
        way = ((c.foot.x - seenX) * c.inwards.x +
               ((c.foot.y - seenY) * c.inwards.y + c.foot.z * c.inwards.z)) *
              (1 / -c.inwards.z);
        point = {seenX, all(seenY), -way};
        way = all(1);
    }
    else
    {
        way = glm::dot(c.foot, c.inwards) /
              (seenX * c.inwards.x + (seenY * c.inwards.y - c.inwards.z));
        point = {way * seenX, way * seenY, -way};
    }
    const Vectors from = point + -c.foot;
    const Floats across = dot(from, c.across);
    const Floats along = dot(from, c.along);
    const ContactShadow& s = c.shadow;
    const Floats shade = contactShadow(across, along, s.height, s.lamp.x, s.lamp.y, s.strength);
    const Floats dark = select((way > 0) & (across * across + along * along < 1), shade, Floats{});
    const Vectors colour = (kWhite * dark) * shading::kShadow;
    return byteOf(colour.x) | byteOf(colour.y) << 8 | byteOf(colour.z) << 16 |
           byteOf(kWhite * dark) << 24;
}

FROSTFILL_INLINE void drawRows(const DrawnContact& contact, const PixelRectangle& rows,
                               const TilePart& whole, TileBackground& pixels)
{
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        for (int x = rows.left; x < rows.right; x += kLanes)
        {
            const Floats middle = static_cast<float>(whole.left + x) + 0.5F + iota();
            const int first = y * kTileEdge + x;
            std::uint32_t* held = pixels.data() + first;
            store(blended(contactAt(contact, middle, static_cast<float>(whole.bottom + y) + 0.5F),
                          load<Words>(held)),
                  held);
        }
    }
}

FROSTFILL_AVX2 void drawAvx2(const DrawnContact& contact, const PixelRectangle& rows,
                             const TilePart& whole, TileBackground& pixels)
{
    drawRows(contact, rows, whole, pixels);
}

void drawPlain(const DrawnContact& contact, const PixelRectangle& rows, const TilePart& whole,
               TileBackground& pixels)
{
    drawRows(contact, rows, whole, pixels);
}

} // namespace

void ContactRaster::draw(const ContactShadows::Seen& seen, const TilePart& whole,
                         TileBackground& pixels) const
{
    const PixelRectangle rows = whole.within(seen.pixels);
    if (rows.empty())
    {
        return;
    }
    const ContactShadow& shadow = seen.shadow;
    const glm::mat3 turn(view_);
    const float scale = 1 / glm::dot(shadow.across, shadow.across);
    const DrawnContact contact{shadow,
                               grid_,
                               glm::vec3(view_ * glm::vec4(shadow.foot, 1)),
                               scale * (turn * shadow.across),
                               scale * (turn * shadow.along()),
                               turn * shadow.inwards};
    (avx2_ ? drawAvx2 : drawPlain)(contact, rows, whole, pixels);
}

} // namespace frostfill
