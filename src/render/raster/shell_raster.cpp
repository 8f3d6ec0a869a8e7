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
    : mesh_(mesh), strokes_(strokes), samples_(samples), avx2_(avx2),
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
            paint.density =
                base.a * (discarded ? (front == 1 ? 0.1F : 0) : (front == 1 ? 0.55F : 0.45F));
            paint.rimDensity = discarded ? (front == 1 ? 0.5F * base.a : 0) : 3 * paint.density;
            paint.ofLine = (front == 1 ? 1.0F : 0.5F) * (discarded ? 0.6F : 1.0F);
            paint.ofEdges = discarded ? 0 : 1;
        }
    }
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
    vertices_.resize(mesh_.positions.size());
    forAll(vertices_.size(), kTrianglesPerTask,
           [&](std::size_t v) { vertices_[v] = placed(mesh_.positions[v]); });
    forAll((places_.size() + kPlacedAtOnce - 1) / kPlacedAtOnce, kTrianglesPerTask / kPlacedAtOnce,
           [&](std::size_t group) { place(static_cast<std::uint32_t>(group * kPlacedAtOnce)); });
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
    order.reserve(places_.size());
    for (const bool front : {false, true})
    {
        for (std::uint32_t t = 0; t < places_.size(); ++t)
        {
            if (const Place& place = places_[t]; place.front == front && !place.pixels.empty())
            {
                order.push_back(t);
            }
        }
    }
    return order;
}

/// Calls visit(setup, frame, pixels) for those that may be seen in a part.
template <class Visit>
void ShellRaster::eachIn(std::span<const std::uint32_t> triangles, const TilePart& part,
                         const RestingTile* resting, Visit visit) const
{
    const ShellRows frame = grid_.orthographic
                                ? ShellRows{0, 0, 0, 0, strokes_.lineWidth}
                                : ShellRows{grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow,
                                            strokes_.lineWidth};
    std::array<Setup, kLanes> setups;
    Some some;
    const auto visitSome = [&]
    {
        std::fill(some.triangles.begin() + static_cast<std::ptrdiff_t>(some.count),
                  some.triangles.end(), some.triangles[some.count - 1]);
        avx2_ ? setUpAvx2(some, setups) : setUpPlain(some, setups);
        for (std::size_t i = 0; i < some.count; ++i)
        {
            if (setups[i].seen)
            {
                visit(setups[i], frame, part.inside(places_[some.triangles[i]].pixels));
            }
        }
        some.count = 0;
    };
    for (const std::uint32_t triangle : triangles)
    {
        const Place& place = places_[triangle];
        if (part.inside(place.pixels).empty() ||
            (resting != nullptr && resting->hides({place.pixels, place.nearest}, part)))
        {
            continue;
        }
        some.triangles[some.count++] = triangle;
        if (some.count == kLanes)
        {
            visitSome();
        }
    }
    if (some.count > 0)
    {
        visitSome();
    }
}

void ShellRaster::draw(std::span<const std::uint32_t> triangles, const TilePart& part,
                       SampleTile& tile, const RestingTile* resting) const
{
    eachIn(triangles, part, resting,
           [&](const Setup& setup, const ShellRows& frame, const PixelRectangle& pixels)
           { drawShellRows(avx2_, samples_, setup, frame, pixels, part, tile); });
}

void ShellRaster::record(std::span<const std::uint32_t> triangles, const TilePart& part,
                         ShellRecord& record) const
{
    eachIn(triangles, part, nullptr,
           [&](const Setup& setup, const ShellRows& frame, const PixelRectangle& pixels)
           { recordShellRows(avx2_, samples_, setup, frame, pixels, part, record); });
}

} // namespace frostfill
