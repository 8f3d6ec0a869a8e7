// SPDX-License-Identifier: MIT
#include "render/raster/shell_raster.hpp"

#include "render/layer/for_all.hpp"
#include "render/passes/mesh_shading.hpp"
#include "render/raster/shell_rows.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const Palette& palette, const MeshStrokes& strokes,
                         int samples, bool avx2)
    : mesh_(mesh), strokes_(strokes), samples_(samples),
      avx2_(avx2), colours_{toVector(palette.activePolygon), toVector(palette.discardedPolygon)},
      inks_{inkFor(palette.activePolygon, palette.background),
            inkFor(palette.discardedPolygon, palette.background)},
      states_(mesh.triangles.size(), PolygonState::active), places_(mesh.triangles.size()),
      setups_(mesh.triangles.size())
{
}

void ShellRaster::lookFrom(const SphereUniforms& uniforms, bool orthographic,
                           const PictureSize& size,
                           std::vector<std::array<std::uint8_t, 3>> edgeStrengths, float front,
                           bool edgeOn)
{
    edgeOn_ = edgeOn;
    view_ = uniforms.view;
    grid_ = pixelGrid(uniforms.projection, orthographic, size);
    size_ = size;
    edges_ = std::move(edgeStrengths);
    front_ = front;
    for (Place& place : places_)
    {
        place.ready = false;
    }
    vertices_.resize(mesh_.positions.size());
    forAll(vertices_.size(), kTrianglesPerTask,
           [&](std::size_t v) { vertices_[v] = placed(mesh_.positions[v]); });
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
            places_[t].ready = false;
            changed_.push_back(static_cast<std::uint32_t>(t));
        }
    }
    return changed_;
}

PixelRectangle ShellRaster::bounds(std::uint32_t triangle)
{
    return placeOf(triangle).pixels;
}

void ShellRaster::setUpAll()
{
    forAll(setups_.size(), kTrianglesPerTask,
           [&](std::size_t t) { placeOf(static_cast<std::uint32_t>(t)); });
}

std::vector<std::uint32_t> ShellRaster::inDrawingOrder()
{
    std::vector<std::uint32_t> order;
    for (const bool front : {false, true})
    {
        for (std::uint32_t t = 0; t < places_.size(); ++t)
        {
            if (const Place& place = placeOf(t); place.covers && place.front == front)
            {
                order.push_back(t);
            }
        }
    }
    return order;
}

const ShellRaster::Place& ShellRaster::placeOf(std::uint32_t triangle)
{
    Place& own = places_[triangle];
    if (!own.ready)
    {
        place(triangle);
        if (own.covers)
        {
            setStrokes(triangle);
        }
        own.ready = true;
    }
    return own;
}

/// Calls visit(triangle, frame, pixels) for those that may be seen in a part.
template <class Visit>
void ShellRaster::eachIn(std::span<const std::uint32_t> triangles, const TilePart& part,
                         Visit visit)
{
    const ShellRows frame = grid_.orthographic
                                ? ShellRows{0, 0, 0, 0, strokes_.lineWidth}
                                : ShellRows{grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow,
                                            strokes_.lineWidth};
    for (const std::uint32_t triangle : triangles)
    {
        const Place& place = placeOf(triangle);
        if (place.seen)
        {
            const PixelRectangle pixels = part.inside(place.pixels);
            if (!pixels.empty())
            {
                visit(triangle, frame, pixels);
            }
        }
    }
}

void ShellRaster::draw(std::span<const std::uint32_t> triangles, const TilePart& part,
                       SampleTile& tile, const RestingTile* resting)
{
    eachIn(triangles, part,
           [&](std::uint32_t triangle, const ShellRows& frame, const PixelRectangle& pixels)
           {
               const Place& place = places_[triangle];
               if (resting == nullptr || !resting->hides({place.pixels, place.nearest}, part))
               {
                   drawShellRows(avx2_, samples_, setups_[triangle], frame, pixels, part, tile);
               }
           });
}

void ShellRaster::record(std::span<const std::uint32_t> triangles, const TilePart& part,
                         ShellRecord& record)
{
    eachIn(triangles, part,
           [&](std::uint32_t triangle, const ShellRows& frame, const PixelRectangle& pixels)
           { recordShellRows(avx2_, samples_, setups_[triangle], frame, pixels, part, record); });
}

} // namespace frostfill
