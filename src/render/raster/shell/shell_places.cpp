// SPDX-License-Identifier: MIT
// Where triangles of the shell lie in the picture.
#include "render/raster/shell/place_specks.hpp"
#include "render/raster/shell/shell_corners.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace frostfill
{
namespace
{

using namespace lanes;

/// What single precision may do to where a triangle ends. [pixel]
constexpr double kCoverMargin = 0.05;

/// What single precision may do to how near a corner is.
constexpr float kNearer = 1e-5F;

/// A triangle of no more than half this area is seen edge-on. [square pixel]
constexpr double kEdgeOn = 1e-12;

/// Where a vertex is ahead of the eye. [unit space]
constexpr double kAhead = 1e-6;
constexpr float kNotAhead = std::numeric_limits<float>::max();

/// Light and angle change evenly over triangles that are smaller than this, and whose normals
/// differ little: what they are in the middle is then less than 1 % off.
constexpr int kSmall = 160; // [pixel]

/// From the edge of a pixel to the nearest sample. [pixel]
double toSample(int samples)
{
    float furthest = 0;
    for (const SampleOffset& sample : kFourSamples)
    {
        furthest = std::max({furthest, sample.x, sample.y, -sample.x, -sample.y});
    }
    return 0.5 - (samples > 1 ? furthest : 0);
}

FROSTFILL_INLINE HalfInts narrowed(LongMask mask)
{
    return __builtin_convertvector(mask, HalfInts);
}

/// Around what lies between two corners, in kHalf lanes; whole pixels.
struct Boxes
{
    HalfInts left, bottom, right, top;

    /// Those that are to stay, as far as they are in the picture; all others are empty.
    [[nodiscard]] FROSTFILL_INLINE Boxes inPicture(const PictureSize& size, HalfInts stay) const
    {
        const HalfInts none{};
        const HalfInts l = left > 0 ? left : none;
        const HalfInts b = bottom > 0 ? bottom : none;
        const HalfInts r = right < size.width ? right : none + size.width;
        const HalfInts t = top < size.height ? top : none + size.height;
        const HalfInts kept = stay & (l < r) & (b < t);
        return {l & kept, b & kept, r & kept, t & kept};
    }

    /// The edges of each, as Place has them.
    [[nodiscard]] FROSTFILL_INLINE std::array<std::array<std::int16_t, 4>, kHalf> each() const
    {
        using FourShorts = std::int16_t __attribute__((vector_size(8)));
        const HalfInts low0 = __builtin_shufflevector(left, bottom, 0, 4, 1, 5);
        const HalfInts low2 = __builtin_shufflevector(left, bottom, 2, 6, 3, 7);
        const HalfInts high0 = __builtin_shufflevector(right, top, 0, 4, 1, 5);
        const HalfInts high2 = __builtin_shufflevector(right, top, 2, 6, 3, 7);
        const auto shorts = [](HalfInts edges) __attribute__((always_inline))
        {
            return __builtin_convertvector(edges, FourShorts);
        };
        const std::array<FourShorts, kHalf> rows = {
            shorts(__builtin_shufflevector(low0, high0, 0, 1, 4, 5)),
            shorts(__builtin_shufflevector(low0, high0, 2, 3, 6, 7)),
            shorts(__builtin_shufflevector(low2, high2, 0, 1, 4, 5)),
            shorts(__builtin_shufflevector(low2, high2, 2, 3, 6, 7))};
        return std::bit_cast<std::array<std::array<std::int16_t, 4>, kHalf>>(rows);
    }
};

} // namespace

FROSTFILL_INLINE void ShellRaster::placeVerticesAny(std::uint32_t first)
{
    const std::size_t count = std::min<std::size_t>(kLanes, vertices_.size() - first);
    Vectors rays;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        const std::size_t v = first + std::min(lane, count - 1);
        const glm::vec3 eye(view_ * glm::vec4(shape_.positions[v], 1));
        const double w = grid_.orthographic ? 1 : -eye.z;
        Vertex& vertex = vertices_[v];
        PlacedVertex& placed = placed_[v];
        vertex.corner = {(eye.x - double{grid_.left} * w) / grid_.perColumn,
                         (eye.y - double{grid_.bottom} * w) / grid_.perRow, w};
        vertex.height = grid_.orthographic ? eye.z + front_ : 1;
        const bool ahead = w > kAhead;
        placed.pixel = ahead ? glm::dvec2(vertex.corner) / w : glm::dvec2(0);
        placed.nearest = ahead ? static_cast<float>(vertex.height / w) : kNotAhead;
        const glm::vec3 ray = grid_.orthographic ? glm::vec3(0, 0, -1) : glm::normalize(eye);
        rays.x[lane] = ray.x;
        rays.y[lane] = ray.y;
        rays.z[lane] = ray.z;
    }
    const auto ofNormal = [&](int axis) __attribute__((always_inline))
    {
        return eight([&](std::size_t lane) __attribute__((always_inline)) {
            return shape_.normals[first + std::min(lane, count - 1)][axis];
        });
    };
    const glm::mat3 view(view_);
    const Vectors own = {ofNormal(0), ofNormal(1), ofNormal(2)};
    const glm::mat3 toOwn = glm::transpose(view);
    const Vectors normal = {dot(own, toOwn[0]), dot(own, toOwn[1]), dot(own, toOwn[2])};
    const Floats length = max(root(dot(normal, normal)), 1e-6F);
    const Floats facing = -dot(normal, rays) / length;
    const Vectors unit = {normal.x / length, normal.y / length, normal.z / length};
    const Floats before = lightInFilm(lightOn(unit));
    const Floats behind = lightInFilm(lightOn({-unit.x, -unit.y, -unit.z}));
    for (std::size_t lane = 0; lane < count; ++lane)
    {
        vertices_[first + lane].normal = {normal.x[lane], normal.y[lane], normal.z[lane]};
        placed_[first + lane].facing = facing[lane];
        placed_[first + lane].light = {behind[lane], before[lane]};
    }
}

FROSTFILL_AVX2 void ShellRaster::placeVerticesAvx2(std::uint32_t first)
{
    placeVerticesAny(first);
}

void ShellRaster::placeVerticesPlain(std::uint32_t first)
{
    placeVerticesAny(first);
}

void ShellRaster::placeVertices(std::uint32_t first)
{
    avx2_ ? placeVerticesAvx2(first) : placeVerticesPlain(first);
}

/// The general rule, for a triangle that is not ahead of the eye.
bool ShellRaster::facesViewer(std::uint32_t triangle) const
{
    const auto& [a, b, c] = shape_.triangles[triangle];
    return glm::dot(vertices_[a].corner, glm::cross(vertices_[b].corner, vertices_[c].corner)) > 0;
}

template <class Ends>
FROSTFILL_INLINE void ShellRaster::placeHalf(std::uint32_t first, const Ends& ends)
{
    const Pixels at(ends);
    const Doubles lowX = min(at.x[0], min(at.x[1], at.x[2]));
    const Doubles lowY = min(at.y[0], min(at.y[1], at.y[2]));
    const Doubles highX = max(at.x[0], max(at.x[1], at.x[2]));
    const Doubles highY = max(at.y[0], max(at.y[1], at.y[2]));
    HalfFloats nearest = HalfFloats{} + kNothing;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto isNear =
            ends.gatherSingle(i, [](const PlacedVertex& v, std::size_t) { return v.nearest; });
        nearest = nearest < isNear ? isNear : nearest;
    }
    // Numbers that an int can hold.
    const double furthestX = 4.0 * size_.width;
    const double furthestY = 4.0 * size_.height;
    const auto clamped = [](Doubles value, double limit) __attribute__((always_inline))
    {
        return min(max(value, Doubles{} - limit), Doubles{} + limit);
    };
    const auto within = [&](double margin) __attribute__((always_inline))
    {
        return Boxes{floorOf(clamped(lowX, furthestX) - margin),
                     floorOf(clamped(lowY, furthestY) - margin),
                     -floorOf(-clamped(highX, furthestX) - margin),
                     -floorOf(-clamped(highY, furthestY) - margin)};
    };
    const Doubles area = areaOf(at.x, at.y);
    const Boxes boxes = within(kCoverMargin - toSample(samples_))
                            .inPicture(size_, narrowed(absolute(area) > kEdgeOn));
    const HalfInts front = narrowed(area > 0.0);
    const HalfInts width = boxes.right - boxes.left;
    const HalfInts height = boxes.top - boxes.bottom;
    const HalfInts small = (width < kSmall) & (height < kSmall);
    const HalfInts speck =
        (width <= ShellSpeck::kEdge) & (height <= ShellSpeck::kEdge) & (width > 0);
    const auto edges = boxes.each();
    const HalfFloats bound = nearest + kNearer * (nearest < 0 ? -nearest : nearest);
    for (std::size_t lane = 0; lane < std::min<std::size_t>(kHalf, places_.size() - first); ++lane)
    {
        Place& place = places_[first + lane];
        place = {edges[lane], bound[lane], front[lane] != 0, small[lane] != 0, speck[lane] != 0};
        if (nearest[lane] == kNotAhead)
        {
            place = {{0, 0, static_cast<std::int16_t>(size_.width),
                      static_cast<std::int16_t>(size_.height)},
                     kNotAhead,
                     facesViewer(first + static_cast<std::uint32_t>(lane)),
                     false,
                     false};
        }
    }
}

FROSTFILL_INLINE void ShellRaster::placeAny(std::uint32_t first)
{
    const auto last = static_cast<std::uint32_t>(places_.size()) - 1;
    const auto half = [&](std::uint32_t from) __attribute__((always_inline))
    {
        return Corners<PlacedVertex>(
            placed_, shape_.triangles, [&](std::size_t lane) __attribute__((always_inline)) {
                return std::min(from + static_cast<std::uint32_t>(lane), last);
            });
    };
    const Corners<PlacedVertex> lower = half(first);
    const Corners<PlacedVertex> upper = half(first + kHalf);
    placeHalf(first, lower);
    if (first + kHalf <= last)
    {
        placeHalf(first + kHalf, upper);
    }
    if (variant_.cutaway)
    {
        cutPlaces(first);
    }
    bool specks = false;
    for (std::uint32_t t = first; t <= std::min(first + kLanes - 1, last); ++t)
    {
        specks = specks || places_[t].speck;
    }
    if (specks)
    {
        placeSpecks(spotsOf(first), lower, upper);
    }
}

FROSTFILL_AVX2 void ShellRaster::placeAvx2(std::uint32_t first)
{
    placeAny(first);
}

void ShellRaster::placePlain(std::uint32_t first)
{
    placeAny(first);
}

void ShellRaster::place(std::uint32_t first)
{
    avx2_ ? placeAvx2(first) : placePlain(first);
}

} // namespace frostfill
