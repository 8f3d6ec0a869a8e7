// SPDX-License-Identifier: MIT
#include "render/raster/swatch_raster.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/raster/lanes/sample_tile.hpp"

#include <frostfill/mesh.hpp>

#include <algorithm>

namespace frostfill
{
SwatchRaster::SwatchRaster(const Viewpoint& viewpoint, int samples) : samples_(samples)
{
    const ShaderVariant variant = variantOfSwatches(viewpoint.variant());
    const RenderSettings& settings = viewpoint.settings();
    const Legend& legend = viewpoint.legend();
    SphereUniforms flat;
    flat.projection = pixelProjection(settings.size);
    flat.supersample = static_cast<float>(settings.supersample);
    const float lineWidth = strokesFor(settings).lineWidth;
    raster_ = std::make_unique<SphereRaster>(flat, variant, settings.size, settings.style,
                                             lineWidth, samples);
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
                                  shapes_.polygons, variant, shellPalette(settings.style),
                                  strokesFor(settings), samples));
    polygons.lookFrom(flat, true, settings.size, shapes_.strengths);
    polygons.setStates(shapes_.states);
    triangles_ = polygons.inDrawingOrder();
    for (const std::uint32_t triangle : triangles_)
    {
        pixels_ = around(pixels_, polygons.bounds(triangle));
    }
}

void SwatchRaster::draw(const TilePart& part, SampleTile& tile)
{
    const PixelRectangle in = part.within(pixels_);
    for (auto& plane : tile.inverseDepth)
    {
        for (int y = in.bottom; y < in.top; ++y)
        {
            std::fill_n(plane.begin() + std::ptrdiff_t{y} * kTileEdge + in.left, in.width(),
                        kNothing);
        }
    }
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
                              tile->colour[k][static_cast<std::size_t>(at)] = premultiplied(colour);
                          }
                      }
                  }
                  draw(part, *tile);
                  resolve(*tile, part, samples_, image);
              });
}

namespace
{

/// Two triangles for each swatch, which face the viewer.
TriangleMesh squares(const std::vector<Legend::Swatch>& swatches, double height)
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

} // namespace

SwatchShapes swatchShapes(const Legend& legend, const SphereColours& colours, int height)
{
    SwatchShapes shapes;
    for (const Legend::Swatch& swatch : legend.spheres())
    {
        const auto state = static_cast<SphereState>(swatch.state);
        shapes.spheres.push_back(
            {static_cast<float>(swatch.x), static_cast<float>(height - swatch.y), 0,
             static_cast<float>(swatch.halfSize), static_cast<std::uint32_t>(colours.marked(state)),
             colours.ofSwatch(state)});
    }
    const TriangleMesh mesh = squares(legend.polygons(), height);
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    shapes.polygons = shadeMesh(mesh, positions);
    shapes.strengths = edgeStrengths(shapes.polygons, {0, 0, 1}, true);
    for (std::size_t t = 0; t + 1 < shapes.strengths.size(); t += 2)
    {
        shapes.strengths[t][1] = shapes.strengths[t + 1][2] = 0; // the diagonals
    }
    for (const Legend::Swatch& swatch : legend.polygons())
    {
        shapes.states.insert(shapes.states.end(), 2, static_cast<PolygonState>(swatch.state));
    }
    return shapes;
}

glm::mat4 pixelProjection(const PictureSize& size)
{
    glm::mat4 projection(0);
    projection[0][0] = 2.0F / static_cast<float>(size.width);
    projection[1][1] = 2.0F / static_cast<float>(size.height);
    projection[2][2] = -1e-6F;
    projection[3] = {-1, -1, -0.9999F, 1};
    return projection;
}

} // namespace frostfill
