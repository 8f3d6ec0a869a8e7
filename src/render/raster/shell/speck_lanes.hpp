// SPDX-License-Identifier: MIT
// How ShellSpecks are worked out, a triangle a lane.
#pragma once

#include "render/raster/shell/setup_columns.hpp"
#include "render/raster/shell/shell_looks.hpp"
#include "render/raster/shell/shell_specks.hpp"
#include "render/raster/shell/shell_surface.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace frostfill::lanes
{

/// The edges of triangles in the picture, a triangle a lane.
template <class Values>
struct SpeckEdges
{
    /// Twice the area between edge and point: across * x + upwards * y + from, inside positive.
    std::array<Values, 3> across, upwards, from;
    std::array<Values, 3> least; ///< it has to be more; see ShellRaster::Setup
    Values area;                 ///< twice that of the triangle
};

/// `area` is twice that of a triangle, negative where it turns its back.
FROSTFILL_INLINE SpeckEdges<HalfFloats> edgesOf(const std::array<Doubles, 3>& x,
                                                const std::array<Doubles, 3>& y, Doubles area)
{
    const LongMask front = area > 0.0;
    SpeckEdges<HalfFloats> edges;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Doubles& fromX = x[(i + 1) % 3];
        const Doubles& fromY = y[(i + 1) % 3];
        const Doubles& toX = x[(i + 2) % 3];
        const Doubles& toY = y[(i + 2) % 3];
        // The other triangle at the edge has these numbers but for the sign: no gap between them.
        const auto inwards = [&](Doubles value) __attribute__((always_inline))
        {
            return inSingle(select(front, value, -value));
        };
        edges.across[i] = inwards(fromY - toY);
        edges.upwards[i] = inwards(toX - fromX);
        edges.from[i] = inwards(fromX * toY - fromY * toX);
        const LongMask swapped = (toX < fromX) | (~(fromX < toX) & (toY < fromY));
        edges.least[i] = inSingle(select(swapped ^ front, Doubles{} - double{1e-30F}, Doubles{}));
    }
    edges.area = inSingle(absolute(area));
    return edges;
}

FROSTFILL_INLINE SpeckEdges<Floats> joined(const SpeckEdges<HalfFloats>& lower,
                                           const SpeckEdges<HalfFloats>& upper)
{
    return {joined(lower.across, upper.across), joined(lower.upwards, upper.upwards),
            joined(lower.from, upper.from), joined(lower.least, upper.least),
            joined(lower.area, upper.area)};
}

/// Which samples are covered, those of two rows each.
using SpeckSamples = std::array<Words, ShellSpeck::kEdge / 2>;

/// `spots` say from which pixel on, and how far.
template <int samples, class Spots>
FROSTFILL_INLINE SpeckSamples covered(const SpeckEdges<Floats>& s, const Spots& spots)
{
    std::array<std::array<Floats, samples>, 3> steps;
    for (std::size_t k = 0; k < samples; ++k)
    {
        const SampleOffset at = samples > 1 ? kFourSamples[k] : SampleOffset{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            steps[i][k] = s.across[i] * at.x + s.upwards[i] * at.y;
        }
    }
    SpeckSamples bits{};
    for (int row = 0; row < spots.rows; ++row)
    {
        const Floats y = spots.bottom + static_cast<float>(row);
        Words& own = bits[static_cast<std::size_t>(row / 2)];
        for (int column = 0; column < spots.columns; ++column)
        {
            const Floats x = spots.left + static_cast<float>(column);
            std::array<Floats, 3> inside;
            for (std::size_t i = 0; i < 3; ++i)
            {
                inside[i] = s.across[i] * x + (s.upwards[i] * y + s.from[i]);
            }
            const int first = (row % 2 * ShellSpeck::kEdge + column) * kMaxTileSamples;
            for (std::size_t k = 0; k < samples; ++k)
            {
                const Mask is = (inside[0] + steps[0][k] > s.least[0]) &
                                (inside[1] + steps[1][k] > s.least[1]) &
                                (inside[2] + steps[2][k] > s.least[2]);
                own |= reinterpret_cast<Words>(is) & (1U << (first + static_cast<int>(k)));
            }
        }
    }
    return bits;
}

/// What changes evenly over a triangle.
struct SpeckPlane
{
    Floats first, across, upwards; ///< as ShellSpeck has it
};

/// From the values at the corners.
FROSTFILL_INLINE SpeckPlane planeOf(const SpeckEdges<Floats>& s, const Slopes& slopes,
                                    const std::array<Floats, 3>& values, Floats left, Floats bottom)
{
    SpeckPlane plane{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Floats share = (s.across[i] * left + (s.upwards[i] * bottom + s.from[i])) / s.area;
        plane.first += values[i] * share;
        plane.across += values[i] * slopes.x[i];
        plane.upwards += values[i] * slopes.y[i];
    }
    return plane;
}

/// Where nothing can be said of how a value changes from pixel to pixel: that of the middle.
FROSTFILL_INLINE SpeckPlane evenIf(Mask even, const std::array<Floats, 3>& values,
                                   const SpeckPlane& plane)
{
    const Floats middle = (values[0] + values[1] + values[2]) / 3;
    return {select(even, middle, plane.first), select(even, Floats{}, plane.across),
            select(even, Floats{}, plane.upwards)};
}

/// Premultiplied.
FROSTFILL_INLINE std::array<Floats, 4> channelsOf(const std::array<Floats, 3>& base,
                                                  const std::array<Floats, 3>& ink, bool print,
                                                  Floats film, Floats light, Floats line)
{
    const Film drawn = lineInFilm(print, film, line);
    const Floats alpha = 255 * min(drawn.film + drawn.line, 1);
    const auto channel = [&](std::size_t i) __attribute__((always_inline))
    {
        return min(base[i] * (drawn.film * light) + ink[i] * drawn.line, alpha);
    };
    return {channel(0), channel(1), channel(2), alpha};
}

/// Whether others' creases reach into the triangles.
FROSTFILL_INLINE Mask creaseDrawn(const StrokeColumns& strokes, float lineWidth)
{
    const auto& off = strokes.creaseDistance;
    const Floats least = min(off[0], min(off[1], off[2]));
    return (strokes.crease > 0) & (least < kCreaseEnd) &
           (onLine(least * strokes.pixelsOfCrease, lineWidth) > 0);
}

/// What a ShellSpeck's colour has for a value.
FROSTFILL_INLINE Mask inColour(Floats value)
{
    constexpr float kOne = 1 << ShellSpeck::kFraction;
    const Floats furthest = all(256 * kOne);
    return __builtin_convertvector(min(max(value * kOne, -furthest), furthest), Mask);
}

/// Two channels in a word.
FROSTFILL_INLINE Floats inOneWord(Mask low, Mask high)
{
    return reinterpret_cast<Floats>((low & 0xffff) | high << 16);
}

/// Many words at a time, as write() for a setup. The colours are those of each channel.
FROSTFILL_INLINE void write(const SpeckSamples& samples, const SpeckPlane& depths,
                            const std::array<std::array<Mask, 3>, 4>& colours,
                            std::array<ShellSpeck, kLanes>& specks)
{
    static_assert(offsetof(ShellSpeck, colour) == 20 && sizeof(ShellSpeck) == 48);
    const auto channels = [&](std::size_t first, std::size_t part) __attribute__((always_inline))
    {
        return inOneWord(colours[first][part], colours[first + 1][part]);
    };
    const std::array<Floats, kLanes> first = {reinterpret_cast<Floats>(samples[0]),
                                              reinterpret_cast<Floats>(samples[1]),
                                              depths.first,
                                              depths.across,
                                              depths.upwards,
                                              channels(0, 0),
                                              channels(2, 0),
                                              channels(0, 1)};
    const std::array<Floats, kLanes> second = {channels(2, 1), channels(0, 2), channels(2, 2)};
    std::array<Floats, kLanes> rows;
    transpose(first.data(), rows);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        std::memcpy(reinterpret_cast<char*>(&specks[lane]), &rows[lane], sizeof(Floats));
    }
    transpose(second.data(), rows);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        std::memcpy(reinterpret_cast<char*>(&specks[lane]) + sizeof(Floats), &rows[lane],
                    sizeof(HalfFloats));
    }
}

} // namespace frostfill::lanes
