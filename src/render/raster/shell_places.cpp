// SPDX-License-Identifier: MIT
// Where triangles of the shell lie in the picture.
#include "render/raster/shell_corners.hpp"
#include "render/raster/shell_raster.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
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

/// A triangle whose determinant is no larger is seen edge-on.
constexpr double kEdgeOn = 1e-12;

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

/// Around what lies between two corners, in kHalf lanes; whole pixels.
struct Boxes
{
    HalfInts left, bottom, right, top;

    [[nodiscard]] FROSTFILL_INLINE PixelRectangle at(std::size_t lane) const
    {
        return {left[lane], bottom[lane], right[lane], top[lane]};
    }
};

} // namespace

ShellRaster::Vertex ShellRaster::placed(const glm::vec3& position) const
{
    const glm::vec3 eye(view_ * glm::vec4(position, 1));
    const double w = grid_.orthographic ? 1 : -eye.z;
    Vertex vertex;
    vertex.corner = {(eye.x - double{grid_.left} * w) / grid_.perColumn,
                     (eye.y - double{grid_.bottom} * w) / grid_.perRow, w};
    vertex.pixel = glm::dvec2(vertex.corner) / w;
    vertex.height = grid_.orthographic ? eye.z + front_ : 1;
    vertex.nearest = static_cast<float>(vertex.height / w);
    vertex.ray = grid_.orthographic ? glm::vec3(0, 0, -1) : glm::normalize(eye);
    return vertex;
}

FROSTFILL_INLINE void ShellRaster::placeAny(std::uint32_t first)
{
    constexpr double kAhead = 1e-6;
    const auto count = static_cast<std::uint32_t>(places_.size());
    const Corners<Vertex> corners(
        vertices_, mesh_.triangles, [&](std::size_t lane) __attribute__((always_inline)) {
            return std::min(first + static_cast<std::uint32_t>(lane), count - 1);
        });
    const std::array<DoubleVectors, 3> at = corners.places();
    Doubles lowX = Doubles{} + 1e9;
    Doubles lowY = lowX;
    Doubles highX = -lowX;
    Doubles highY = -lowX;
    LongMask ahead = ~LongMask{};
    HalfFloats nearest = HalfFloats{} + kNothing;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto x = corners.gather(i, [](const Vertex& v) { return v.pixel.x; });
        const auto y = corners.gather(i, [](const Vertex& v) { return v.pixel.y; });
        const auto isNear = corners.gatherSingle(i, [](const Vertex& v) { return v.nearest; });
        nearest = nearest < isNear ? isNear : nearest;
        lowX = min(lowX, x);
        lowY = min(lowY, y);
        highX = max(highX, x);
        highY = max(highY, y);
        ahead &= at[i].z > kAhead;
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
    const Boxes tight = within(kCoverMargin - toSample(samples_));
    const Boxes wide = within(1);
    const Doubles determinants = dot(at[0], cross(at[1], at[2]));
    const LongMask faces = determinants > 0.0;
    const LongMask drawn = absolute(determinants) > kEdgeOn;
    const PixelRectangle picture = {0, 0, size_.width, size_.height};
    for (std::size_t lane = 0; lane < std::min<std::size_t>(kHalf, count - first); ++lane)
    {
        const bool isAhead = ahead[lane] != 0;
        const auto inPicture = [&](const Boxes& boxes) __attribute__((always_inline))
        {
            return isAhead ? common(boxes.at(lane), picture) : picture;
        };
        const PixelRectangle around = inPicture(wide);
        Place& place = places_[first + lane];
        place.pixels = drawn[lane] != 0 ? inPicture(tight) : PixelRectangle{};
        place.front = faces[lane] != 0;
        place.small = around.width() < kSmall && around.height() < kSmall;
        place.nearest = isAhead ? nearest[lane] + kNearer * std::abs(nearest[lane])
                                : std::numeric_limits<float>::max();
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
