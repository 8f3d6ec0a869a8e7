// SPDX-License-Identifier: MIT
#include "render/raster/swatch_raster.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/sample_tile.hpp"

#include <frostfill/mesh.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

/// Two triangles for each swatch, which face the viewer. `height` is that of the picture.
TriangleMesh squaresOf(const std::vector<Legend::Swatch>& swatches, double height)
{
    TriangleMesh mesh;
    for (const Legend::Swatch& swatch : swatches)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        {
            mesh.vertices.emplace_back(swatch.x + x * swatch.halfSize,
                                       height - swatch.y + y * swatch.halfSize, 0);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

/// From pixels to clip space. Swatches lie at the very front of the depth range.
glm::mat4 pixelProjection(const PictureSize& size)
{
    glm::mat4 projection(0);
    projection[0][0] = 2.0F / static_cast<float>(size.width);
    projection[1][1] = 2.0F / static_cast<float>(size.height);
    projection[2][2] = -1e-6F;
    projection[3] = {-1, -1, -0.9999F, 1};
    return projection;
}

} // namespace

SwatchRaster::SwatchRaster(const Viewpoint& viewpoint)
    : samples_(viewpoint.settings().samples > 1 ? kMaxTileSamples : 1)
{
    const ShaderVariant variant = variantOfSwatches(viewpoint.variant());
    const RenderSettings& settings = viewpoint.settings();
    const Legend& legend = viewpoint.legend();
    const int height = settings.size.height;
    SphereUniforms flat;
    flat.projection = pixelProjection(settings.size);
    flat.supersample = static_cast<float>(settings.supersample);
    raster_ = std::make_unique<SphereRaster>(flat, variant, settings.size, settings.style,
                                             strokesFor(settings).lineWidth, samples_);
    for (const Legend::Swatch& swatch : legend.spheres())
    {
        const auto state = static_cast<SphereState>(swatch.state);
        const SphereInstance& sphere = spheres_.emplace_back(
            SphereInstance{static_cast<float>(swatch.x), static_cast<float>(height - swatch.y), 0,
                           static_cast<float>(swatch.halfSize),
                           static_cast<std::uint32_t>(viewpoint.colours().marked(state)),
                           viewpoint.colours().ofSwatch(state)});
        const auto left = static_cast<int>(sphere.x - sphere.radius) - 1;
        const auto bottom = static_cast<int>(sphere.y - sphere.radius) - 1;
        const auto edge = static_cast<int>(2 * sphere.radius) + 4;
        placed_.push_back({left, bottom, left + edge, bottom + edge});
        pixels_ = around(pixels_, placed_.back());
    }
    const TriangleMesh mesh = squaresOf(legend.polygons(), height);
    squares_ = shadeMesh(mesh, inUnitSpace(mesh, {}));
    strengths_ = edgeStrengths(squares_, {0, 0, 1}, true);
    for (std::size_t t = 0; t + 1 < strengths_.size(); t += 2)
    {
        strengths_[t][1] = strengths_[t + 1][2] = 0; // the diagonals
    }
    std::vector<PolygonState> states;
    for (const Legend::Swatch& swatch : legend.polygons())
    {
        states.insert(states.end(), 2, static_cast<PolygonState>(swatch.state));
    }
    polygons_ = std::make_unique<ShellRaster>(squares_, variant, shellPalette(settings.style),
                                              strokesFor(settings), samples_);
    polygons_->lookFrom(flat, true, settings.size, strengths_);
    polygons_->setStates(states);
    triangles_ = polygons_->inDrawingOrder();
    for (const std::uint32_t triangle : triangles_)
    {
        pixels_ = around(pixels_, polygons_->bounds(triangle));
    }
    pixels_ = common(inWholeLanes(pixels_), {0, 0, settings.size.width, height});
}

void SwatchRaster::draw(Image& image)
{
    const TileGrid grid({image.width, image.height});
    const auto tile = std::make_unique<SampleTile>();
    const auto drawIn = [&](std::size_t index)
    {
        for (auto& plane : tile->inverseDepth)
        {
            plane.fill(kNothing);
        }
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
                for (auto& plane : tile->colour)
                {
                    plane[static_cast<std::size_t>(at)] = premultiplied(colour);
                }
            }
        }
        for (std::size_t i = 0; i < spheres_.size(); ++i)
        {
            raster_->draw(spheres_[i], placed_[i], part, *tile);
        }
        polygons_->draw(triangles_, part, *tile);
        resolve(*tile, part, samples_, image);
    };
    grid.each(pixels_, drawIn);
}

} // namespace frostfill
