// SPDX-License-Identifier: MIT
// Which triangles of the shell are specks, and how they look; for shell_places.cpp.
#pragma once

#include "render/raster/shell/speck_lanes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace frostfill
{
namespace lanes
{

/// The outline of a smooth surface changes evenly over a speck if it differs by no more between its
/// corners.
inline constexpr float kEvenContour = 0.1F;

/// Twice the area of triangles in the picture, negative where they turn their backs.
FROSTFILL_INLINE Doubles areaOf(const std::array<Doubles, 3>& x, const std::array<Doubles, 3>& y)
{
    return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

/// Where the corners of triangles are in the picture.
struct Pixels
{
    std::array<Doubles, 3> x, y;

    template <class Ends>
    FROSTFILL_INLINE explicit Pixels(const Ends& ends)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            x[i] = ends.gather(i, [](const auto& v) { return v.pixel.x; });
            y[i] = ends.gather(i, [](const auto& v) { return v.pixel.y; });
        }
    }
};

} // namespace lanes

/// What is looked at for being specks: kLanes triangles, and where in the picture.
struct ShellRaster::SpeckSpots
{
    Triangles triangles;
    lanes::Floats left, bottom; ///< the middle of the first pixel
    int columns = 0;            ///< no speck has a sample further
    int rows = 0;
};

/// Their colours, as ShellSpeck has them.
struct ShellRaster::SpeckColours
{
    std::array<std::array<lanes::Mask, 3>, 4> channels;
    lanes::Mask enough; ///< nothing else is drawn on them
};

FROSTFILL_INLINE ShellRaster::SpeckSpots ShellRaster::spotsOf(std::uint32_t first) const
{
    SpeckSpots spots;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        const std::uint32_t t = std::min(first + static_cast<std::uint32_t>(lane),
                                         static_cast<std::uint32_t>(places_.size() - 1));
        const Place& place = places_[t];
        spots.triangles[lane] = t;
        spots.left[lane] = static_cast<float>(place.edges[0]) + 0.5F;
        spots.bottom[lane] = static_cast<float>(place.edges[1]) + 0.5F;
        if (place.speck)
        {
            spots.columns = std::max(spots.columns, place.edges[2] - place.edges[0]);
            spots.rows = std::max(spots.rows, place.edges[3] - place.edges[1]);
        }
    }
    return spots;
}

template <class Ends, class Edges>
FROSTFILL_INLINE ShellRaster::SpeckColours
ShellRaster::coloursOf(const SpeckSpots& spots, const Ends& lower, const Ends& upper,
                       const Edges& edges, const lanes::Slopes& slopes) const
{
    using namespace lanes;
    const PaintLanes paints(*this, spots.triangles);
    StrokeColumns strokes;
    setStrokes(spots.triangles, paints, slopes, strokes);
    LightColumns light;
    setLight(spots.triangles, lower, upper, slopes, light);
    std::array<Floats, 3> base;
    std::array<Floats, 3> ink;
    for (int i = 0; i < 3; ++i)
    {
        base[static_cast<std::size_t>(i)] = paints([&](const Paint& p) { return p.base[i]; });
        ink[static_cast<std::size_t>(i)] = paints([&](const Paint& p) { return p.ink[i]; });
    }
    const Floats density = paints([](const Paint& p) { return p.own.density; });
    const Floats rimDensity = paints([](const Paint& p) { return p.own.rimDensity; });

    // At the corners.
    std::array<std::array<Floats, 3>, 4> ofCorners; // of each channel
    Floats least = all(1);
    Floats most = all(0);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Floats facing = abs(light.facing[i]);
        const Floats contour =
            contourLine(strokes.contour, facing, light.pixelsOfFacing, strokes_.lineWidth);
        least = min(least, contour);
        most = max(most, contour);
        const auto channels =
            channelsOf(base, ink, variant_.outlines, filmShare(density, rimDensity, facing),
                       light.light[i], contour);
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
            ofCorners[channel][i] = channels[channel];
        }
    }

    // From pixel to pixel, unless the triangle is too thin to tell.
    const Mask thin = slopes.pixels() < 1;
    SpeckColours colours;
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
        const std::array<Floats, 3>& values = ofCorners[channel];
        const SpeckPlane plane =
            evenIf(thin, values, planeOf(edges, slopes, values, spots.left, spots.bottom));
        colours.channels[channel] = {inColour(plane.first), inColour(plane.across),
                                     inColour(plane.upwards)};
    }
    colours.enough =
        ~((most - least > kEvenContour) | strokes.edges | creaseDrawn(strokes, strokes_.lineWidth));
    return colours;
}

template <class Ends>
FROSTFILL_INLINE void ShellRaster::placeSpecks(const SpeckSpots& spots, const Ends& lower,
                                               const Ends& upper)
{
    using namespace lanes;
    const auto edgesOfHalf = [](const Ends& ends) __attribute__((always_inline))
    {
        const Pixels at(ends);
        return edgesOf(at.x, at.y, areaOf(at.x, at.y));
    };
    const SpeckEdges<Floats> edges = joined(edgesOfHalf(lower), edgesOfHalf(upper));
    const SpeckSamples samples =
        samples_ > 1 ? covered<kMaxTileSamples>(edges, spots) : covered<1>(edges, spots);
    Slopes slopes;
    std::array<Floats, 3> inverseDepths;
    for (std::size_t i = 0; i < 3; ++i)
    {
        slopes.x[i] = edges.across[i] / edges.area;
        slopes.y[i] = edges.upwards[i] / edges.area;
        const auto isNear = [](const PlacedVertex& v, std::size_t) { return v.nearest; };
        inverseDepths[i] = joined(lower.gatherSingle(i, isNear), upper.gatherSingle(i, isNear));
    }
    SpeckPlane depths = planeOf(edges, slopes, inverseDepths, spots.left, spots.bottom);
    if (samples_ == 1) // it is drawn as if the only sample were the first of several
    {
        const SampleOffset& at = kFourSamples[0];
        depths.first -= depths.across * at.x + depths.upwards * at.y;
    }
    const SpeckColours colours = coloursOf(spots, lower, upper, edges, slopes);
    std::array<ShellSpeck, kLanes> specks;
    write(samples, depths, colours.channels, specks);
    const std::uint32_t first = spots.triangles[0];
    std::uint8_t which = 0;
    for (std::size_t lane = 0; lane < std::min<std::size_t>(kLanes, places_.size() - first); ++lane)
    {
        Place& place = places_[first + lane];
        if (!place.speck)
        {
            continue;
        }
        if (specks[lane].covered == 0)
        {
            place.edges = {};
        }
        place.speck = specks[lane].covered != 0 && colours.enough[lane] != 0;
        if (place.speck)
        {
            place.which = which;
            specks_[first + which++] = specks[lane];
        }
    }
}

} // namespace frostfill
