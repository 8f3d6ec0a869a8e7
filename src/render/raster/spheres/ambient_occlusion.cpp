// SPDX-License-Identifier: MIT
#include "render/raster/spheres/ambient_occlusion.hpp"

#include "render/raster/lanes/shading.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace frostfill
{
namespace
{

using namespace lanes;
using Scene = AmbientOcclusion::Scene;

constexpr int kSamples = 16;
constexpr double kTurns = 7; ///< of the spiral on which samples lie; coprime to their number

/// Neighbouring pixels take turned spirals, which a blur over as many pixels evens out.
constexpr int kTile = 4;
static_assert(kLanes % kTile == 0);

/// What lies less steeply than this above a surface's plane does not shade it: the surface itself
/// does, seen through the rounding of its normals.
constexpr float kBias = 0.06F;

/// How dark the deepest shade is, and how much of the sky it takes to get there.
constexpr float kDarkest = 0.22F;
constexpr float kGain = 5;

/// Samples are spread over at most so many pixels; further away it is one shade.
constexpr float kMaxPixels = 160;
constexpr float kMinPixels = 1.5F;

/// Any distance is less, where there is a surface.
constexpr float kFurthest = 1e30F;

/// Where the samples of kLanes pixels of a row lie, over how far they are spread. [share]
struct Spiral
{
    std::array<Floats, kSamples> right, down;
};

/// For each row of a tile.
std::array<Spiral, kTile> spirals()
{
    std::array<Spiral, kTile> all;
    for (int y = 0; y < kTile; ++y)
    {
        for (int i = 0; i < kSamples; ++i)
        {
            const double share = (i + 0.5) / kSamples;
            for (int x = 0; x < kLanes; ++x)
            {
                const int turn = x % kTile * kTile + y;
                const double angle =
                    2 * M_PI * (share * kTurns + static_cast<double>(turn) / (kTile * kTile));
                Spiral& spiral = all[static_cast<std::size_t>(y)];
                const auto sample = static_cast<std::size_t>(i);
                spiral.right[sample][x] = static_cast<float>(share * std::cos(angle));
                spiral.down[sample][x] = static_cast<float>(share * std::sin(angle));
            }
        }
    }
    return all;
}

FROSTFILL_INLINE Floats inFloats(Mask value)
{
    return __builtin_convertvector(value, Floats);
}

/// Halves away from zero.
FROSTFILL_INLINE Mask nearest(Floats value)
{
    return __builtin_convertvector(value + select(value < 0, all(-0.5F), 0.5F), Mask);
}

/// In eye space, of the middles of pixels; rows downwards.
FROSTFILL_INLINE Vectors placeOf(const Scene& scene, Floats column, Floats row, Floats distance)
{
    const PixelGrid& grid = scene.grid;
    const Floats x = grid.left + grid.perColumn * (column + 0.5F);
    const Floats y =
        grid.bottom + grid.perRow * (static_cast<float>(scene.surfaces.height) - 0.5F - row);
    return grid.orthographic ? Vectors{x, y, -distance}
                             : Vectors{x * distance, y * distance, -distance};
}

/// The light on kLanes pixels of a row, the first of which is at a multiple of kLanes. What is
/// beyond the row's end is that of its last pixel.
FROSTFILL_INLINE Floats lightAt(const Scene& scene, const Spiral& spiral, int x, int y)
{
    const Surfaces& surfaces = scene.surfaces;
    const int width = surfaces.width;
    const auto pixel = [&](std::size_t lane) __attribute__((always_inline))
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               std::min(static_cast<std::size_t>(x) + lane, static_cast<std::size_t>(width - 1));
    };
    const Floats seen = eight([&](std::size_t lane) __attribute__((always_inline)) {
        return surfaces.distance[pixel(lane)];
    });
    const Floats distance = min(seen, all(kFurthest));
    const Floats pixels =
        min(scene.reach * scene.pixelScale / (scene.grid.orthographic ? all(1) : distance),
            all(kMaxPixels));
    const Mask shaded = (seen < kFurthest) & (pixels >= kMinPixels);
    if (!any(shaded))
    {
        return all(1);
    }
    const auto ofNormal = [&](std::size_t c) __attribute__((always_inline))
    {
        return eight([&](std::size_t lane) __attribute__((always_inline)) {
                   return static_cast<float>(surfaces.normal[pixel(lane)][c]);
               }) * (1 / 127.5F) -
               1;
    };
    const Vectors normal = {ofNormal(0), ofNormal(1), ofNormal(2)};
    const Mask columns = Mask{0, 1, 2, 3, 4, 5, 6, 7} + x;
    const Vectors point = placeOf(scene, inFloats(columns), all(static_cast<float>(y)), distance);
    const float overSquare = 1 / (scene.reach * scene.reach);
    Floats sum{};
    for (std::size_t i = 0; i < kSamples; ++i)
    {
        const Mask column = columns + nearest(spiral.right[i] * pixels);
        const Mask row = y + nearest(spiral.down[i] * pixels);
        const Mask inside = (column >= 0) & (column < width) & (row >= 0) & (row < surfaces.height);
        const Mask index = (row * width + column) & inside;
        const Floats other = eight([&](std::size_t lane) __attribute__((always_inline)) {
            return surfaces.distance[static_cast<std::size_t>(index[lane])];
        });
        const Vectors to =
            placeOf(scene, inFloats(column), inFloats(row), min(other, all(kFurthest)));
        const Vectors way = {to.x - point.x, to.y - point.y, to.z - point.z};
        const Floats squared = dot(way, way);
        const Floats steep = dot(way, normal) / root(squared + 1e-12F) - kBias;
        const Floats shade = max(steep, 0) * max(1 - squared * overSquare, 0);
        sum += select(inside & (other < kFurthest), shade, 0);
    }
    return select(shaded, max(1 - kGain / kSamples * sum, kDarkest), 1);
}

/// The columns of a row between which there are surfaces.
std::array<int, 2> columnsSeen(const Surfaces& surfaces, int y)
{
    const float* row = surfaces.distance.data() + static_cast<std::ptrdiff_t>(y) * surfaces.width;
    const auto isSeen = [](float distance) { return distance != Surfaces::kNothing; };
    const auto first = std::find_if(row, row + surfaces.width, isSeen) - row;
    auto end = static_cast<std::ptrdiff_t>(surfaces.width);
    while (end > first && !isSeen(row[end - 1]))
    {
        --end;
    }
    return {static_cast<int>(first), static_cast<int>(end)};
}

FROSTFILL_INLINE void lightRow(const Scene& scene, const std::array<Spiral, kTile>& spirals, int y,
                               float* light)
{
    const Spiral& spiral = spirals[static_cast<std::size_t>(y % kTile)];
    const auto [from, to] = scene.columns[static_cast<std::size_t>(y)];
    std::array<float, kLanes> own;
    for (int x = from & ~(kLanes - 1); x < to; x += kLanes)
    {
        store(lightAt(scene, spiral, x, y), own.data());
        std::copy_n(own.data(), std::min(kLanes, scene.surfaces.width - x), light + x);
    }
}

/// The mean over a tile's worth of neighbours on the same surface.
FROSTFILL_INLINE void evenOutRow(const Scene& scene, const float* rough, int y, float* light)
{
    const Surfaces& surfaces = scene.surfaces;
    const int width = surfaces.width;
    const auto [from, to] = scene.columns[static_cast<std::size_t>(y)];
    const float* distances = surfaces.distance.data();
    const float step = scene.reach / 2;
    constexpr int kHalfTile = kTile / 2;
    for (int x = from & ~(kLanes - 1); x < to; x += kLanes)
    {
        const bool within = x >= kHalfTile && x + kLanes + kHalfTile <= width;
        const auto read = [&](const float* plane, int column, int row)
            __attribute__((always_inline))
        {
            const float* line = plane + static_cast<std::ptrdiff_t>(row) * width;
            return within
                       ? load<Floats>(line + column)
                       : eight([&](std::size_t lane) __attribute__((always_inline)) {
                             return line[std::clamp(column + static_cast<int>(lane), 0, width - 1)];
                         });
        };
        const Floats own = read(distances, x, y);
        Floats sum{};
        Floats count{};
        for (int v = std::max(0, y - kHalfTile); v < std::min(surfaces.height, y + kHalfTile); ++v)
        {
            for (int u = -kHalfTile; u < kHalfTile; ++u)
            {
                const Floats column = static_cast<float>(x + u) + iota();
                const Mask near = (abs(read(distances, x + u, v) - own) < step) & (column >= 0) &
                                  (column < static_cast<float>(width));
                sum += select(near, read(rough, x + u, v), 0);
                count += select(near, all(1), 0);
            }
        }
        std::array<float, kLanes> result;
        store(select(count > 0, sum / max(count, 1), 1), result.data());
        std::copy_n(result.data(), std::min(kLanes, width - x), light + x);
    }
}

FROSTFILL_AVX2 void lightRowAvx2(const Scene& scene, const std::array<Spiral, kTile>& spirals,
                                 int y, float* light)
{
    lightRow(scene, spirals, y, light);
}

void lightRowPlain(const Scene& scene, const std::array<Spiral, kTile>& spirals, int y,
                   float* light)
{
    lightRow(scene, spirals, y, light);
}

FROSTFILL_AVX2 void evenOutRowAvx2(const Scene& scene, const float* rough, int y, float* light)
{
    evenOutRow(scene, rough, y, light);
}

void evenOutRowPlain(const Scene& scene, const float* rough, int y, float* light)
{
    evenOutRow(scene, rough, y, light);
}

template <class Row>
void forEachRow(int height, Row row)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16),
                      [&](const tbb::blocked_range<int>& rows)
                      {
                          for (int y = rows.begin(); y < rows.end(); ++y)
                          {
                              row(y);
                          }
                      });
}

Scene sceneOf(const Surfaces& surfaces, const Framing& framing, double reach)
{
    const PictureSize size{surfaces.width, surfaces.height};
    Scene scene{surfaces,
                pixelGrid(framing.projection, framing.orthographic, size),
                static_cast<float>(reach),
                static_cast<float>(0.5 * framing.projection[1][1] * surfaces.height),
                {}};
    scene.columns.resize(static_cast<std::size_t>(surfaces.height));
    forEachRow(surfaces.height, [&](int y)
               { scene.columns[static_cast<std::size_t>(y)] = columnsSeen(surfaces, y); });
    return scene;
}

} // namespace

void AmbientOcclusion::findLight(const Scene& scene)
{
    const Surfaces& surfaces = scene.surfaces;
    const std::array<Spiral, kTile> ways = spirals();
    rough_.resize(surfaces.distance.size());
    light_.resize(surfaces.distance.size());
    const auto lineOf = [&](std::vector<float>& plane, int y)
    { return plane.data() + static_cast<std::ptrdiff_t>(y) * surfaces.width; };
    forEachRow(surfaces.height, [&](int y)
               { (avx2_ ? lightRowAvx2 : lightRowPlain)(scene, ways, y, lineOf(rough_, y)); });
    forEachRow(surfaces.height,
               [&](int y) {
                   (avx2_ ? evenOutRowAvx2 : evenOutRowPlain)(scene, rough_.data(), y,
                                                              lineOf(light_, y));
               });
}

const std::vector<float>& AmbientOcclusion::lightOn(const Surfaces& surfaces,
                                                    const Framing& framing, double reach)
{
    light_.assign(surfaces.distance.size(), 1);
    findLight(sceneOf(surfaces, framing, reach));
    return light_;
}

void AmbientOcclusion::darken(const Surfaces& surfaces, const Framing& framing, double reach,
                              Image& image)
{
    const Scene scene = sceneOf(surfaces, framing, reach);
    findLight(scene);
    const auto channels = static_cast<std::size_t>(image.channels);
    forEachRow(surfaces.height,
               [&](int y)
               {
                   const auto [from, to] = scene.columns[static_cast<std::size_t>(y)];
                   const auto row = static_cast<std::size_t>(y * surfaces.width);
                   for (std::size_t i = row + static_cast<std::size_t>(from);
                        i < row + static_cast<std::size_t>(to); ++i)
                   {
                       std::uint8_t* pixel = image.pixels.data() + i * channels;
                       for (std::size_t c = 0; light_[i] < 1 && c < 3; ++c)
                       {
                           pixel[c] = static_cast<std::uint8_t>(
                               static_cast<float>(pixel[c]) * light_[i] + 0.5F);
                       }
                   }
               });
}

} // namespace frostfill
