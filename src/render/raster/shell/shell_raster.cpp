// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_raster.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/raster/lanes/shading.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace frostfill
{
namespace
{

/// Of a distance from a cut, where the line at its end keeps its width. [1 / pixel]
constexpr float kAnySteepness = 1e6F;

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const ShaderVariant& variant,
                         const Palette& palette, const MeshStrokes& strokes, int samples)
    : mesh_(mesh), variant_(variant), strokes_(strokes), samples_(samples), shape_(mesh),
      states_(mesh.triangles.size(), PolygonState::active), places_(mesh.triangles.size())
{
    const std::array<Colour, 2> colours = {palette.activePolygon, palette.discardedPolygon};
    for (std::size_t state = 0; state < colours.size(); ++state)
    {
        const bool discarded = static_cast<PolygonState>(state) == PolygonState::discarded;
        const glm::vec4 base = toVector(colours[state]);
        for (std::size_t front = 0; front < 2; ++front)
        {
            Paint& paint = paints_[state][front];
            paint.base = 255.0F * glm::vec3(base);
            paint.ink = 255.0F * inkFor(colours[state], palette.background);
            paint.own = lanes::paintOf(base.a, discarded, front == 1);
        }
    }
}

void ShellRaster::lookFrom(const SphereUniforms& uniforms, bool orthographic,
                           const PictureSize& size,
                           std::span<const std::array<std::uint8_t, 3>> edgeStrengths, float front)
{
    view_ = uniforms.view;
    grid_ = pixelGrid(uniforms.projection, orthographic, size);
    rows_ = {};
    if (!orthographic)
    {
        rows_ = {grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow};
    }
    rows_.lineWidth = strokes_.lineWidth;
    rows_.print = variant_.outlines;
    rows_.cut = {orthographic, grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow};
    rows_.cut.steepest = shading::kSteepest * grid_.perRow;
    rows_.cut.steepestBefore = variant_.fadingLines ? rows_.cut.steepest : kAnySteepness;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const glm::vec4& plane = uniforms.cutPlanes[i];
        rows_.cut.planes[i] = {plane.x, plane.y, plane.z, plane.w};
    }
    size_ = size;
    edges_ = edgeStrengths;
    front_ = front;
    vertices_.resize(shape_.positions.size());
    forAll(vertices_.size(), kTrianglesPerTask, [&](std::size_t v) { placeVertex(v); });
    forAll(places_.size(), kTrianglesPerTask,
           [&](std::size_t t) { places_[t] = placeOf(static_cast<std::uint32_t>(t)); });
}

std::span<const std::uint32_t> ShellRaster::setStates(std::span<const PolygonState> states)
{
    changed_.clear();
    const std::size_t given = std::min(states.size(), states_.size());
    for (std::size_t t = 0; t < states_.size(); ++t)
    {
        const PolygonState state = t < given ? states[t] : PolygonState::active;
        if (state != states_[t])
        {
            states_[t] = state;
            changed_.push_back(static_cast<std::uint32_t>(t));
        }
    }
    return changed_;
}

std::vector<std::uint32_t> ShellRaster::inDrawingOrder() const
{
    std::vector<std::uint32_t> order;
    eachInDrawingOrder([&](std::uint32_t t) { order.push_back(t); });
    return order;
}

void ShellRaster::draw(std::span<const std::uint32_t> triangles, const TilePart& part,
                       SampleTile& tile, const RestingTile* resting) const
{
    for (const std::uint32_t triangle : triangles)
    {
        const Place& place = places_[triangle];
        const PixelRectangle pixels = part.inside(place.pixels());
        if (!pixels.empty() &&
            (resting == nullptr || !resting->hides({place.pixels(), place.nearest}, part)))
        {
            drawShellRows(samples_, setUp(triangle), rows_, pixels, part, tile);
        }
    }
}

void ShellRaster::record(std::span<const std::uint32_t> triangles, const TilePart& part,
                         std::vector<ShellPiece>& pieces) const
{
    const auto empty = std::make_unique<SampleTile>();
    for (std::size_t plane = 0; plane < kMaxTileSamples; ++plane)
    {
        empty->inverseDepth[plane].fill(kNothing);
    }
    for (const std::uint32_t triangle : triangles)
    {
        const PixelRectangle pixels = part.inside(places_[triangle].pixels());
        if (!pixels.empty())
        {
            drawShellRows(samples_, setUp(triangle), rows_, pixels, part, *empty, &pieces);
        }
    }
}

void ShellRaster::blend(std::span<const ShellPiece> pieces, const PixelRectangle& pixels,
                        SampleTile& tile) const
{
    const auto first = std::partition_point(
        pieces.begin(), pieces.end(), [&](const ShellPiece& p) { return p.row() < pixels.bottom; });
    const auto end = std::partition_point(
        first, pieces.end(), [&](const ShellPiece& p) { return p.row() < pixels.top; });
    blendShellPieces({first, end}, pixels, tile);
}

} // namespace frostfill
