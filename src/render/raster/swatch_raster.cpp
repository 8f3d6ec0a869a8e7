// SPDX-License-Identifier: MIT
#include "render/raster/swatch_raster.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/tile_grid.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// Added to how near swatches are: more than anything else without perspective, and in single
/// precision still finer than their shape needs.
constexpr float kInFront = 1e5F;

} // namespace

SwatchRaster::SwatchRaster(const Viewpoint& viewpoint, const ShaderVariant& variant, int samples)
    : samples_(samples)
{
    const RenderSettings& settings = viewpoint.settings();
    const Legend& legend = viewpoint.legend();
    SphereUniforms flat;
    flat.projection = pixelProjection(settings.size);
    flat.supersample = static_cast<float>(settings.supersample);
    const float lineWidth = strokesFor(settings).lineWidth;
    raster_ = std::make_unique<SphereRaster>(flat, variantOfSwatches(variant), settings.size,
                                             settings.style, lineWidth, samples, kInFront);
    shapes_ = swatchShapes(legend, viewpoint.colours(), settings.size.height);
    for (const SphereInstance& sphere : shapes_.spheres)
    {
        const auto left = static_cast<int>(sphere.x - sphere.radius) - 1;
        const auto bottom = static_cast<int>(sphere.y - sphere.radius) - 1;
        const auto edge = static_cast<int>(2 * sphere.radius) + 4;
        placed_.push_back({{left, bottom, left + edge, bottom + edge}, 0});
        pixels_ = around(pixels_, placed_.back().pixels);
    }
    ShellRaster& polygons = *(polygons_ = std::make_unique<ShellRaster>(
                                  shapes_.polygons, variantOfSwatches(variant),
                                  shellPalette(settings.style), strokesFor(settings), samples));
    polygons.lookFrom(flat, true, settings.size, shapes_.strengths, 2 * kInFront);
    polygons.setStates(shapes_.states);
    triangles_ = polygons.inDrawingOrder();
    for (const std::uint32_t triangle : triangles_)
    {
        pixels_ = around(pixels_, polygons.bounds(triangle));
    }
}

void SwatchRaster::draw(const TilePart& part, SampleTile& tile)
{
    for (std::size_t i = 0; i < shapes_.spheres.size(); ++i)
    {
        raster_->draw(shapes_.spheres[i], placed_[i].pixels, part, tile);
    }
    polygons_->draw(triangles_, part, tile);
}

void SwatchRaster::draw(Image& image)
{
    const TileGrid grid({image.width, image.height});
    const auto tile = std::make_unique<SampleTile>();
    grid.each(pixels_,
              [&](std::size_t index)
              {
                  TilePart part = grid.part(index);
                  part.pixels = part.within(pixels_);
                  const PixelRectangle& in = part.pixels;
                  for (int y = in.bottom; y < std::min(in.top, image.height - part.bottom); ++y)
                  {
                      for (int x = in.left; x < std::min(in.right, image.width - part.left); ++x)
                      {
                          const std::uint8_t* from =
                              image.at(part.left + x, image.height - 1 - part.bottom - y);
                          const Colour colour = {from[0], from[1], from[2],
                                                 image.channels == 4 ? from[3] : std::uint8_t{255}};
                          const int at = y * kTileEdge + x;
                          for (std::size_t k = 0; k < kMaxTileSamples; ++k)
                          {
                              tile->inverseDepth[k][static_cast<std::size_t>(at)] = kNothing;
                              tile->colour[k][static_cast<std::size_t>(at)] = premultiplied(colour);
                          }
                      }
                  }
                  draw(part, *tile);
                  resolve(*tile, part, samples_, image);
              });
}

} // namespace frostfill
