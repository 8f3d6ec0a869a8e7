// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_raster.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/raster/lanes/shading.hpp"
#include "render/raster/shell/shell_rows.hpp"
#include "render/raster/shell/shell_specks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Of a distance from a cut, where the line at its end keeps its width. [1 / pixel]
constexpr float kAnySteepness = 1e6F;

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

/// In their order, and few enough to be found in the cache once more.
constexpr std::size_t kDrawnAtOnce = 256;

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const ShaderVariant& variant,
                         const Palette& palette, const MeshStrokes& strokes, int samples, bool avx2)
    : mesh_(mesh), variant_(variant), strokes_(strokes), samples_(samples), avx2_(avx2),
      shape_(mesh), states_(mesh.triangles.size(), PolygonState::active),
      places_(mesh.triangles.size()), specks_(mesh.triangles.size())
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

void ShellRaster::cutPlaces(std::uint32_t first)
{
    const auto depth = [&](std::size_t plane, const glm::vec3& eye)
    {
        const auto& [x, y, z, w] = rows_.cut.planes[plane];
        return x * eye.x + y * eye.y + z * eye.z + w;
    };
    for (std::uint32_t t = first; t < std::min<std::size_t>(first + kLanes, places_.size()); ++t)
    {
        const std::array<glm::vec3, 3> corners = mesh_.corners(t);
        std::array<glm::vec3, 3> eye;
        std::transform(corners.begin(), corners.end(), eye.begin(),
                       [&](const glm::vec3& corner)
                       { return glm::vec3(view_ * glm::vec4(corner, 1)); });
        const auto [nearest, furthest] = std::minmax({-eye[0].z, -eye[1].z, -eye[2].z});
        const bool ahead = grid_.orthographic || nearest > 0;
        float least = -kNothing; // of the depths at either plane: the smaller, all over it
        float most = -kNothing;
        for (std::size_t i = 0; i < 2; ++i)
        {
            const auto [low, high] =
                std::minmax({depth(i, eye[0]), depth(i, eye[1]), depth(i, eye[2])});
            least = std::min(least, low);
            most = std::min(most, high);
        }
        // How far from the cut its line and the end of the surface reach, and for rounding.
        const float distance = grid_.orthographic ? 1 : furthest;
        const float beyond = rows_.cut.steepest * distance;
        const float before = rows_.cut.steepestBefore * distance;
        Place& place = places_[t];
        place.cut = !ahead || most > -(1.5F * strokes_.lineWidth + 0.6F) * before - 1e-5F;
        place.speck = place.speck && !place.cut;
        if (ahead && least > 0.6F * beyond + 1e-5F)
        {
            place.edges = {}; // nothing of it is left
        }
    }
}

} // namespace frostfill
