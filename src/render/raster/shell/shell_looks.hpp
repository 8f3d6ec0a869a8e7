// SPDX-License-Identifier: MIT
// What triangles have whose looks are worked out, a triangle a lane.
#pragma once

#include "render/raster/lanes/shading.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "render/raster/shell/shell_sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace frostfill
{
namespace lanes
{

/// From the square of a gradient: the length over which a value changes by 1. [pixel]
FROSTFILL_INLINE Floats pixelsOf(Floats square)
{
    return 1 / root(max(square, 1e-12F));
}

/// Slopes of the barycentric coordinates in the middle of each triangle.
struct Slopes
{
    std::array<Floats, 3> x, y;

    Slopes() = default;
    FROSTFILL_INLINE explicit Slopes(const ShellSides<Floats>& sides)
    {
        // The coordinates are all 1/3 where share * distance is the same for all three; its value
        // there is 1 / (3 w) with w the mean of the corners'.
        Floats w{};
        Floats sumX{};
        Floats sumY{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            w += sides.divisors[i] / 3;
            sumX += x[i] = sides.share[i] * sides.across[i];
            sumY += y[i] = sides.share[i] * sides.upwards[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
            x[i] = w * (x[i] - sumX / 3);
            y[i] = w * (y[i] - sumY / 3);
        }
    }
    /// Of the steepest coordinate.
    [[nodiscard]] FROSTFILL_INLINE Floats pixels() const
    {
        Floats most{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            most = max(x[i] * x[i] + y[i] * y[i], most);
        }
        return pixelsOf(most);
    }
    /// Of a value that is known at the corners.
    [[nodiscard]] FROSTFILL_INLINE Floats pixelsOfValue(const std::array<Floats, 3>& values) const
    {
        const Floats ofX = values[0] * x[0] + values[1] * x[1] + values[2] * x[2];
        const Floats ofY = values[0] * y[0] + values[1] * y[1] + values[2] * y[2];
        return pixelsOf(ofX * ofX + ofY * ofY);
    }
};

/// Returns how strongly others' creases are drawn.
template <class Columns>
FROSTFILL_INLINE Floats creases(const ShadedMesh& mesh,
                                const std::array<std::uint32_t, kLanes>& triangles,
                                const Slopes& slopes, Floats sizeInLines, Floats ofLine,
                                Columns& columns)
{
    std::array<Floats, 3> distances = {all(1), all(1), all(1)};
    Floats crease{};
    Floats pixels{};
    if (!mesh.creaseDistances.empty())
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            distances[i] = eight([&](std::size_t lane) __attribute__((always_inline)) {
                return mesh.creaseDistances[triangles[lane]][i];
            });
        }
        pixels = slopes.pixelsOfValue(distances);
        crease = ofLine * creaseStrength(sizeInLines, pixels);
    }
    columns.crease = crease;
    columns.pixelsOfCrease = pixels;
    for (std::size_t i = 0; i < 3; ++i)
    {
        columns.creaseDistance[i] = distances[i];
    }
    return crease;
}

/// What setLight() finds out.
struct LightColumns
{
    std::array<Floats, 3> facing, light;
    Floats pixelsOfFacing;
};

/// What setStrokes() finds out.
struct StrokeColumns
{
    std::array<Floats, 3> strength, creaseDistance;
    Floats contour, crease, pixelsOfCrease;
    Mask edges; ///< whether any line along an edge is drawn
    Mask lines; ///< whether any line is
};

} // namespace lanes

/// The paints of triangles: mostly that of one for all.
class ShellRaster::PaintLanes
{
public:
    FROSTFILL_INLINE PaintLanes(const ShellRaster& shell, const Triangles& triangles)
    {
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            const std::uint32_t t = triangles[lane];
            paints_[lane] = &shell.paintOf(shell.states_[t], shell.places_[t].front);
            alike_ = alike_ && paints_[lane] == paints_[0];
        }
    }

    template <class ValueOf>
    FROSTFILL_INLINE lanes::Floats operator()(ValueOf valueOf) const
    {
        return alike_ ? lanes::all(valueOf(*paints_[0]))
                      : lanes::eight([&](std::size_t lane) __attribute__((always_inline)) {
                            return valueOf(*paints_[lane]);
                        });
    }

private:
    std::array<const Paint*, kLanes> paints_;
    bool alike_ = true;
};

/// `lower` and `upper` are the ends of the first and the second half of the triangles.
template <class Ends, class Columns>
FROSTFILL_INLINE void ShellRaster::setLight(const Triangles& triangles, const Ends& lower,
                                            const Ends& upper, const lanes::Slopes& slopes,
                                            Columns& columns) const
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto ofEnd = [&](auto valueOf) __attribute__((always_inline))
        {
            const auto inHalf = [&](const Ends& ends, std::size_t first)
                __attribute__((always_inline))
            {
                return ends.gatherSingle(
                    i, [&](const PlacedVertex& v, std::size_t lane)
                    { return valueOf(v, places_[triangles[first + lane]].front); });
            };
            return lanes::joined(inHalf(lower, 0), inHalf(upper, lanes::kHalf));
        };
        columns.facing[i] =
            ofEnd([](const PlacedVertex& v, bool front) { return front ? v.facing : -v.facing; });
        columns.light[i] =
            ofEnd([](const PlacedVertex& v, bool front) { return v.light[front ? 1 : 0]; });
    }
    columns.pixelsOfFacing = slopes.pixelsOfValue(columns.facing);
}

template <class Columns>
FROSTFILL_INLINE void ShellRaster::setStrokes(const Triangles& triangles, const PaintLanes& paints,
                                              const lanes::Slopes& slopes, Columns& columns) const
{
    using namespace lanes;
    const Floats ofLine = paints([](const Paint& paint) { return paint.own.ofLine; });
    const Floats size = slopes.pixels();
    const bool fading = variant_.fadingLines;
    const Floats plainShown = fading
                                  ? paints([](const Paint& paint) { return paint.own.ofEdges; }) *
                                        smoothstep(strokes_.edgeFade[0], strokes_.edgeFade[1], size)
                                  : all(1);
    const Floats outline = fading ? outlineShown(size / strokes_.lineWidth) : all(1);
    Words ofEdges; // the strength of each in a byte
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        const std::array<std::uint8_t, 3>& own = edges_[triangles[lane]];
        ofEdges[lane] = own[0] | std::uint32_t{own[1]} << 8 | std::uint32_t{own[2]} << 16;
    }
    Mask edgesDrawn{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Words byte = ofEdges >> (8 * i) & 255;
        const Floats strength = __builtin_convertvector(reinterpret_cast<Mask>(byte), Floats) / 255;
        const Floats drawn = ofLine * edgeStrength(strength, plainShown, outline);
        edgesDrawn |= drawn > 0;
        columns.strength[i] = drawn;
    }
    const Floats contour = ofLine * contourStrength(outline);
    columns.contour = contour;
    const Mask lines =
        edgesDrawn | (contour > 0) |
        (creases(mesh_, triangles, slopes, size / strokes_.lineWidth, ofLine, columns) > 0);
    columns.edges = edgesDrawn;
    columns.lines = lines;
}

} // namespace frostfill
