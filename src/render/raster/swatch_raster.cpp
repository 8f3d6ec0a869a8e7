// SPDX-License-Identifier: MIT
#include "render/raster/swatch_raster.hpp"

#include "render/picture/painter_settings.hpp"

namespace frostfill
{
namespace
{

/// Added to how near swatches are: more than anything else without perspective, and in single
/// precision still finer than their shape needs.
constexpr float kInFront = 1e5F;

} // namespace

SwatchRaster::SwatchRaster(const Viewpoint& viewpoint, const ShaderVariant& variant, int samples,
                           bool avx2)
{
    const RenderSettings& settings = viewpoint.settings();
    const Legend& legend = viewpoint.legend();
    SphereUniforms flat;
    flat.projection = pixelProjection(settings.size);
    flat.supersample = static_cast<float>(settings.supersample);
    const float lineWidth = strokesFor(settings).lineWidth;
    raster_ = std::make_unique<SphereRaster>(flat, variantOfSwatches(variant), settings.size,
                                             settings.style, lineWidth, samples, avx2, kInFront);
    shapes_ = swatchShapes(legend, viewpoint.colours(), settings.size.height);
    for (const SphereInstance& sphere : shapes_.spheres)
    {
        const auto left = static_cast<int>(sphere.x - sphere.radius) - 1;
        const auto bottom = static_cast<int>(sphere.y - sphere.radius) - 1;
        const auto edge = static_cast<int>(2 * sphere.radius) + 4;
        placed_.push_back({{left, bottom, left + edge, bottom + edge}, 0});
        pixels_ = around(pixels_, placed_.back().pixels);
    }
    ShellRaster& polygons =
        *(polygons_ = std::make_unique<ShellRaster>(shapes_.polygons, variantOfSwatches(variant),
                                                    shellPalette(settings.style),
                                                    strokesFor(settings), samples, avx2));
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

} // namespace frostfill
