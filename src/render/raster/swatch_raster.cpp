// SPDX-License-Identifier: MIT
#include "render/raster/swatch_raster.hpp"

#include "render/layer/painter_settings.hpp"
#include "render/layer/swatch_mesh.hpp"

namespace frostfill
{
namespace
{

/// Added to how near swatches are: more than anything else without perspective, and in single
/// precision still finer than their shape needs.
constexpr float kInFront = 1e5F;

} // namespace

SwatchRaster::SwatchRaster(const Viewpoint& viewpoint, int samples, bool avx2)
{
    const RenderSettings& settings = viewpoint.settings();
    const Legend& legend = viewpoint.legend();
    SphereUniforms flat;
    flat.projection = pixelProjection(settings.size);
    raster_ = std::make_unique<SphereRaster>(
        flat, true, settings.size, settings.style.palette.background, samples, avx2, kInFront);
    const auto height = static_cast<double>(settings.size.height);
    for (const Legend::Swatch& swatch : legend.spheres())
    {
        const SphereInstance sphere = {
            static_cast<float>(swatch.x),
            static_cast<float>(height - swatch.y),
            0,
            static_cast<float>(swatch.halfSize),
            static_cast<std::uint32_t>(swatch.state),
            viewpoint.colours().ofSwatch(static_cast<SphereState>(swatch.state))};
        const auto left = static_cast<int>(swatch.x - swatch.halfSize) - 1;
        const auto bottom = static_cast<int>(height - swatch.y - swatch.halfSize) - 1;
        const auto edge = static_cast<int>(2 * swatch.halfSize) + 4;
        spheres_.push_back(sphere);
        placed_.push_back({{left, bottom, left + edge, bottom + edge}, 0});
        pixels_ = around(pixels_, placed_.back().pixels);
    }
    const TriangleMesh mesh = squares(legend.polygons(), height);
    mesh_ = shadeMesh(mesh, positionsOf(mesh));
    edges_ = edgeStrengths(mesh_, {0, 0, 1}, true);
    for (std::size_t t = 0; t + 1 < edges_.size(); t += 2)
    {
        edges_[t][1] = edges_[t + 1][2] = 0; // the diagonals
    }
    ShellRaster& polygons =
        *(polygons_ = std::make_unique<ShellRaster>(mesh_, shellPalette(settings.style),
                                                    strokesFor(settings), samples, avx2));
    // With perspective the programs take them for being seen edge-on.
    polygons.lookFrom(flat, true, settings.size, edges_, 2 * kInFront,
                      !viewpoint.framing().orthographic);
    std::vector<PolygonState> states;
    for (const Legend::Swatch& swatch : legend.polygons())
    {
        states.insert(states.end(), 2, static_cast<PolygonState>(swatch.state));
    }
    polygons.setStates(states);
    triangles_ = polygons.inDrawingOrder();
    for (const std::uint32_t triangle : triangles_)
    {
        pixels_ = around(pixels_, polygons.bounds(triangle));
    }
}

void SwatchRaster::draw(const TilePart& part, SampleTile& tile)
{
    for (std::size_t i = 0; i < spheres_.size(); ++i)
    {
        raster_->draw(spheres_[i], placed_[i].pixels, part, tile);
    }
    polygons_->draw(triangles_, part, tile);
}

} // namespace frostfill
