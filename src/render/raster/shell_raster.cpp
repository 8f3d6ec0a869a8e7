// SPDX-License-Identifier: MIT
#include "render/raster/shell_raster.hpp"

#include "render/layer/for_all.hpp"
#include "render/passes/mesh_shading.hpp"
#include "render/raster/shell_rows.hpp"
#include "render/raster/shell_specks.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

/// In their order, and few enough to be found in the cache once more.
constexpr std::size_t kDrawnAtOnce = 256;

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const Palette& palette, const MeshStrokes& strokes,
                         int samples, bool avx2)
    : mesh_(mesh), strokes_(strokes), samples_(samples), avx2_(avx2), shape_(mesh),
      states_(mesh.triangles.size(), PolygonState::active), places_(mesh.triangles.size()),
      specks_(mesh.triangles.size())
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
                           std::span<const std::array<std::uint8_t, 3>> edgeStrengths, float front)
{
    view_ = uniforms.view;
    grid_ = pixelGrid(uniforms.projection, orthographic, size);
    rows_ = orthographic ? ShellRows{0, 0, 0, 0, strokes_.lineWidth}
                         : ShellRows{grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow,
                                     strokes_.lineWidth};
    size_ = size;
    edges_ = edgeStrengths;
    front_ = front;
    vertices_.resize(shape_.positions.size());
    placed_.resize(shape_.positions.size());
    forAll((vertices_.size() + kLanes - 1) / kLanes, kTrianglesPerTask / kLanes,
           [&](std::size_t group) { placeVertices(static_cast<std::uint32_t>(group * kLanes)); });
    forAll((places_.size() + kLanes - 1) / kLanes, kTrianglesPerTask / kLanes,
           [&](std::size_t group) { place(static_cast<std::uint32_t>(group * kLanes)); });
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
    for (std::size_t i = 0; i < changed_.size() && !vertices_.empty(); ++i)
    {
        const std::uint32_t group = changed_[i] - changed_[i] % kLanes;
        if (i == 0 || group != changed_[i - 1] - changed_[i - 1] % kLanes)
        {
            place(group); // specks have colours
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

template <class Target>
void ShellRaster::drawTo(Target& target, std::span<const std::uint32_t> triangles,
                         const TilePart& part, const RestingTile* resting) const
{
    std::array<Setup, kLanes> setups;
    Triangles toSetUp{};
    std::size_t setUp = 0;
    std::array<std::uint32_t, kDrawnAtOnce> some;
    std::size_t count = 0;
    const auto drawSome = [&]
    {
        if (setUp > 0)
        {
            std::fill(toSetUp.begin() + static_cast<std::ptrdiff_t>(setUp), toSetUp.end(),
                      toSetUp[setUp - 1]);
            avx2_ ? setUpAvx2(toSetUp, setups) : setUpPlain(toSetUp, setups);
        }
        const Setup* next = setups.data();
        for (std::size_t i = 0; i < count; ++i)
        {
            const Place& place = places_[some[i]];
            const PixelRectangle own = part.inTile(place.pixels());
            const PixelRectangle pixels = common(own, part.pixels);
            if (place.speck)
            {
                drawSpeck(avx2_, speckOf(some[i]), own, pixels, target);
                continue;
            }
            const Setup& setup = *next++;
            if (setup.seen)
            {
                drawShellRows(avx2_, samples_, setup, rows_, pixels, part, target);
            }
        }
        count = 0;
        setUp = 0;
    };
    for (const std::uint32_t triangle : triangles)
    {
        const Place& place = places_[triangle];
        const PixelRectangle pixels = place.pixels();
        if (part.inside(pixels).empty() ||
            (resting != nullptr && resting->hides({pixels, place.nearest}, part)))
        {
            continue;
        }
        some[count++] = triangle;
        if (!place.speck)
        {
            toSetUp[setUp++] = triangle;
        }
        if (count == kDrawnAtOnce || setUp == kLanes)
        {
            drawSome();
        }
    }
    drawSome();
}

void ShellRaster::draw(std::span<const std::uint32_t> triangles, const TilePart& part,
                       SampleTile& tile, const RestingTile* resting) const
{
    drawTo(tile, triangles, part, resting);
}

void ShellRaster::record(std::span<const std::uint32_t> triangles, const TilePart& part,
                         ShellRecord& record) const
{
    drawTo(record, triangles, part, nullptr);
}

} // namespace frostfill
