// SPDX-License-Identifier: MIT
// How triangles of the shell look in a point, and how their rows are drawn.
#include "render/raster/shell/shell_raster.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/raster/lanes/shading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace frostfill
{

namespace
{

using namespace lanes;
using Setup = ShellRaster::Setup;
using Frame = ShellRows;

/// How far a point is from the cut in the picture, positive beyond it, where it is `nearness`,
/// which changes by `nearX` and `nearY` from pixel to pixel. [pixel]
FROSTFILL_INLINE Floats pixelsFromCut(const Frame& f, Floats x, Floats y, Floats nearness,
                                      float nearX, float nearY)
{
    const PixelGrid& grid = f.grid;
    const ShellCut& cut = f.cut;
    const Floats over = grid.orthographic ? all(1) : 1 / nearness;
    const Floats rayX = grid.left + grid.perColumn * x;
    const Floats rayY = grid.bottom + grid.perRow * y;
    std::array<Floats, 2> depth;
    std::array<Floats, 2> slope;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto& [a, b, c, d] = cut.planes[i];
        const Floats beside = a * rayX + b * rayY;
        const Floats ahead = grid.orthographic ? beside + c * nearness : (beside - c) * over;
        const Floats bySideX = grid.orthographic ? all(c * nearX) : -ahead * nearX;
        const Floats bySideY = grid.orthographic ? all(c * nearY) : -ahead * nearY;
        const Floats slopeX = (a * grid.perColumn + bySideX) * over;
        const Floats slopeY = (b * grid.perRow + bySideY) * over;
        depth[i] = ahead + d;
        slope[i] = abs(slopeX) + abs(slopeY);
    }
    const Mask first = depth[0] < depth[1];
    const Floats nearest = select(first, depth[0], depth[1]);
    const Floats steepest = select(nearest > 0, all(cut.steepest), cut.steepestBefore) * over;
    return nearest / min(max(select(first, slope[0], slope[1]), 1e-6F), steepest);
}

struct SurfaceSample
{
    Floats share;
    Floats light;
};

/// The light on a point of the surface, and how far it faces the viewer, from the normal there.
FROSTFILL_INLINE Floats curved(const Setup& s, const Frame& f, Floats x, Floats y, Floats b0,
                               Floats b1, Floats b2, Floats& facing)
{
    const Floats nx = b0 * s.normals[0].x + b1 * s.normals[1].x + b2 * s.normals[2].x;
    const Floats ny = b0 * s.normals[0].y + b1 * s.normals[1].y + b2 * s.normals[2].y;
    const Floats nz = b0 * s.normals[0].z + b1 * s.normals[1].z + b2 * s.normals[2].z;
    const Floats length = 1 / root(max(nx * nx + ny * ny + nz * nz, 1e-12F));
    const bool parallel = f.grid.orthographic;
    const Floats rayX = parallel ? Floats{} : f.grid.left + f.grid.perColumn * x;
    const Floats rayY = parallel ? Floats{} : f.grid.bottom + f.grid.perRow * y;
    const Floats towards =
        (nz - nx * rayX - ny * rayY) * length / root(rayX * rayX + (1 + rayY * rayY));
    facing = abs(towards);
    return lightInFilm(lightOn({nx * length, ny * length, nz * length}));
}

/// Of the surface: how much it covers and the light on it; and how much its lines cover of that.
template <bool lines>
FROSTFILL_INLINE std::pair<SurfaceSample, Floats>
surfaceAndLine(const Setup& s, const Frame& f, Floats x, Floats y, Floats d0, Floats d1, Floats d2)
{
    const Floats l0 = s.share[0] * d0;
    const Floats l1 = s.share[1] * d1;
    const Floats l2 = s.share[2] * d2;
    const Floats over = 1 / max(l0 + l1 + l2, 1e-12F);
    const Floats b0 = l0 * over;
    const Floats b1 = l1 * over;
    const Floats b2 = l2 * over;
    SurfaceSample surface;
    Floats facing;
    if (s.flat)
    {
        facing = b0 * s.facing[0] + b1 * s.facing[1] + b2 * s.facing[2];
        facing = abs(facing);
        surface.light = b0 * s.light[0] + b1 * s.light[1] + b2 * s.light[2];
    }
    else
    {
        surface.light = curved(s, f, x, y, b0, b1, b2, facing);
    }
    surface.share = filmShare(all(s.density), all(s.rimDensity), facing);
    if constexpr (!lines)
    {
        return {surface, Floats{}};
    }
    Floats line{};
    if (s.edges)
    {
        line = max(
            s.strength[0] * onLine(d0, f.lineWidth),
            max(s.strength[1] * onLine(d1, f.lineWidth), s.strength[2] * onLine(d2, f.lineWidth)));
    }
    if (s.contour > 0)
    {
        line = max(line, contourLine(all(s.contour), facing, all(s.pixelsOfFacing), f.lineWidth));
    }
    if (s.crease > 0)
    {
        const Floats away =
            b0 * s.creaseDistance[0] + b1 * s.creaseDistance[1] + b2 * s.creaseDistance[2];
        line = max(line, creaseLine(all(s.crease), away, all(s.pixelsOfCrease), f.lineWidth));
    }
    return {surface, line};
}

/// What there is on a triangle.
enum class Detail
{
    film,
    lines,
    cut, ///< lines too
};

/// Draws a triangle, kLanes pixels of a row at a time.
template <int samples, Detail detail>
struct Painter
{
    const Setup s; // a copy, so that the tile cannot be part of it
    const Frame f;
    SampleTile& tile;
    std::vector<ShellPiece>* const record;
    std::array<std::array<float, samples>, 3> edgeAt;
    std::array<float, samples> nearAt;
    float nearX = 0;
    float nearY = 0;

    FROSTFILL_INLINE Painter(const Setup& setup, const Frame& frame, SampleTile& to,
                             std::vector<ShellPiece>* pieces)
        : s(setup), f(frame), tile(to), record(pieces)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            nearX += s.near[i] * s.across[i];
            nearY += s.near[i] * s.upwards[i];
        }
        for (std::size_t k = 0; k < samples; ++k)
        {
            const SampleOffset at = samples > 1 ? kFourSamples[k] : SampleOffset{};
            nearAt[k] = nearX * at.x + nearY * at.y;
            for (std::size_t i = 0; i < 3; ++i)
            {
                edgeAt[i][k] = s.across[i] * at.x + s.upwards[i] * at.y;
            }
        }
    }

    /// At the pixels around (x, y), which lie in the tile from `at` on.
    FROSTFILL_INLINE void draw(Floats x, Floats y, std::size_t at)
    {
        const Floats d0 = s.across[0] * x + (s.upwards[0] * y + s.from[0]);
        const Floats d1 = s.across[1] * x + (s.upwards[1] * y + s.from[1]);
        const Floats d2 = s.across[2] * x + (s.upwards[2] * y + s.from[2]);
        const Floats nearness = s.near[0] * d0 + s.near[1] * d1 + s.near[2] * d2;
        std::array<Words, samples> seen;
        Mask seenAtAll{};
        for (std::size_t k = 0; k < samples; ++k)
        {
            const Mask is = (d0 + edgeAt[0][k] > s.least[0]) & (d1 + edgeAt[1][k] > s.least[1]) &
                            (d2 + edgeAt[2][k] > s.least[2]) &
                            (nearness + nearAt[k] > load<Floats>(tile.inverseDepth[k].data() + at));
            seen[k] = reinterpret_cast<Words>(is);
            seenAtAll |= is;
        }
        if (!any(seenAtAll))
        {
            return;
        }
        const auto [surface, line] = surfaceAndLine<detail != Detail::film>(s, f, x, y, d0, d1, d2);
        Film film{surface.share, {}};
        if constexpr (detail == Detail::cut)
        {
            const Floats away = pixelsFromCut(f, x, y, nearness, nearX, nearY);
            const Floats left = leftOfCut(away);
            film = lineInFilm(f.print, surface.share, max(line, lineOfCut(away, f.lineWidth)));
            film.film *= left;
            film.line *= left;
        }
        else if constexpr (detail == Detail::lines)
        {
            film = lineInFilm(f.print, surface.share, line);
        }
        const Words alpha = byteOf(255 * (film.film + film.line));
        const Floats limit = __builtin_convertvector(reinterpret_cast<Mask>(alpha), Floats);
        const Floats lit = film.film * surface.light;
        const auto channel = [&](float base, float ink) __attribute__((always_inline))
        {
            return byteOf(min(base * lit + ink * film.line, limit));
        };
        const Words colour = channel(s.base.r, s.ink.r) | channel(s.base.g, s.ink.g) << 8 |
                             channel(s.base.b, s.ink.b) << 16 | alpha << 24;
        for (std::size_t k = 0; k < samples; ++k)
        {
            const Words drawn = colour & seen[k]; // clear if not seen
            std::uint32_t* shown = tile.colour[k].data() + at;
            store(blended(drawn, load<Words>(shown)), shown);
            if (record != nullptr && any(drawn != 0))
            {
                ShellPiece& piece = record->emplace_back();
                store(nearness + nearAt[k], piece.inverseDepth.data());
                store(drawn, piece.colour.data());
                piece.plane = static_cast<std::uint16_t>(k);
                piece.at = static_cast<std::uint16_t>(at);
            }
        }
    }
};

template <int samples, Detail detail>
FROSTFILL_INLINE void drawRows(const Setup& setup, const Frame& frame, const PixelRectangle& pixels,
                               const TilePart& part, SampleTile& tile,
                               std::vector<ShellPiece>* record)
{
    Painter<samples, detail> painter(setup, frame, tile, record);
    const PixelRectangle rows = inWholeLanes(pixels);
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float yAt = static_cast<float>(part.bottom + y) + 0.5F;
        for (int x = rows.left; x < rows.right; x += kLanes)
        {
            const int pixel = y * kTileEdge + x;
            painter.draw(static_cast<float>(part.left + x) + 0.5F + iota(), all(yAt),
                         static_cast<std::size_t>(pixel));
        }
    }
}

template <int samples>
FROSTFILL_INLINE void drawDetail(const Setup& setup, const Frame& frame,
                                 const PixelRectangle& pixels, const TilePart& part,
                                 SampleTile& tile, std::vector<ShellPiece>* record)
{
    if (setup.cut)
    {
        drawRows<samples, Detail::cut>(setup, frame, pixels, part, tile, record);
    }
    else if (setup.lines)
    {
        drawRows<samples, Detail::lines>(setup, frame, pixels, part, tile, record);
    }
    else
    {
        drawRows<samples, Detail::film>(setup, frame, pixels, part, tile, record);
    }
}

/// Where a piece is before what is there.
FROSTFILL_INLINE void blendAny(std::span<const ShellPiece> pieces, const PixelRectangle& pixels,
                               SampleTile& tile)
{
    for (const ShellPiece& piece : pieces)
    {
        const int column = piece.at % kTileEdge;
        if (column >= pixels.left && column < pixels.right)
        {
            std::uint32_t* shown = tile.colour[piece.plane].data() + piece.at;
            const Mask seen = load<Floats>(piece.inverseDepth.data()) >
                              load<Floats>(tile.inverseDepth[piece.plane].data() + piece.at);
            store(blended(load<Words>(piece.colour.data()) & reinterpret_cast<Words>(seen),
                          load<Words>(shown)),
                  shown);
        }
    }
}

/// Blends a triangle over what a part of a tile has of it, and adds to `record` what it blends.
void drawShellRows(int samples, const Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, SampleTile& tile,
                   std::vector<ShellPiece>* record = nullptr)
{
    if (!setup.seen)
    {
        return;
    }
    inLanes([&]() __attribute__((always_inline)) {
        samples > 1 ? drawDetail<kMaxTileSamples>(setup, frame, pixels, part, tile, record)
                    : drawDetail<1>(setup, frame, pixels, part, tile, record);
    });
}

/// Blends pieces over what has these columns.
void blendShellPieces(std::span<const ShellPiece> pieces, const PixelRectangle& pixels,
                      SampleTile& tile)
{
    inLanes([&]() __attribute__((always_inline)) { blendAny(pieces, pixels, tile); });
}

/// Of a distance from a cut, where the line at its end keeps its width. [1 / pixel]
constexpr float kAnySteepness = 1e6F;

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const ShaderVariant& variant,
                         const Palette& palette, const MeshStrokes& strokes, int samples)
    : mesh_(mesh), variant_(variant), strokes_(strokes), samples_(samples),
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
                           std::span<const std::array<std::uint8_t, 3>> edgeStrengths)
{
    view_ = uniforms.view;
    rows_.grid = pixelGrid(uniforms.projection, orthographic, size);
    rows_.lineWidth = strokes_.lineWidth;
    rows_.print = variant_.outlines;
    rows_.cut.steepest = shading::kSteepest * rows_.grid.perRow;
    rows_.cut.steepestBefore = variant_.fadingLines ? rows_.cut.steepest : kAnySteepness;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const glm::vec4& plane = uniforms.cutPlanes[i];
        rows_.cut.planes[i] = {plane.x, plane.y, plane.z, plane.w};
    }
    size_ = size;
    edges_ = edgeStrengths;
    vertices_.resize(mesh_.positions.size());
    forAll(vertices_.size(), kTrianglesPerTask, [&](std::size_t v) { placeVertex(v); });
    forAll(places_.size(), kTrianglesPerTask,
           [&](std::size_t t) { places_[t] = placeOf(static_cast<std::uint32_t>(t)); });
}

std::vector<std::uint32_t> ShellRaster::inDrawingOrder() const
{
    std::vector<std::uint32_t> order;
    for (const bool front : {false, true})
    {
        for (std::uint32_t t = 0; t < places_.size(); ++t)
        {
            if (places_[t].front == front && !places_[t].empty())
            {
                order.push_back(t);
            }
        }
    }
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
