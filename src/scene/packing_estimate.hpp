// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{

// Equal spheres of radius r in an object of volume V and surface S take about phi (V - c r S). Far
// from walls, a random packing takes the share phi of the volume. A wall removes a layer of c
// radii. One pair of numbers serves to estimate how many spheres fit, for all motions.
inline constexpr double kPackingFraction = 0.586; ///< phi
inline constexpr double kWallLayer = 0.38;        ///< c

/// Sizes of spheres, in the radius that is looked for.
struct RelativeRadii
{
    double mean = 1;       ///< mean of r
    double meanOfCube = 1; ///< mean of r^3
};

/// How many spheres fill an object of this volume [unit^3] and surface [unit^2]: phi (V - c r S)
/// over the volume of one.
[[nodiscard]] inline double packedCount(double volume, double area, double radius,
                                        const RelativeRadii& radii = {})
{
    const double room = volume - kWallLayer * radius * radii.mean * area;
    const double one = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * radii.meanOfCube;
    return std::max(0.0, kPackingFraction * room / one);
}

/// Share of the estimate that is asked for when a radius is chosen: the number that fits differs
/// from the estimate by a few hundredths. Larger: runs end before their count. Smaller: emptier
/// objects.
inline constexpr double kShareOfEstimate = 0.9;

/// The same pair for one motion, fitted to cube, sphere, torus, human and spot (the cow) at
/// r S / V = 0.15 and 0.3 (means of three and six seeds), and the remaining errors.
struct PackingCalibration
{
    double fraction;     ///< phi
    double wallLayer;    ///< c
    double formulaError; ///< largest error of (N v / phi + c r S) / V over these fillings
    double ruleFraction; ///< phi of the two-radius rule
    double ruleError;    ///< largest error of (2 N(r/2) v(r/2) - N(r) v(r)) / phi / V, r of 0.3
};

[[nodiscard]] inline PackingCalibration packingCalibration(const Scene& scene)
{
    if (scene.preset == Preset::paper)
    {
        return {0.586, 0.38, 0.0093, 0.586, 0.0093}; // other shapes, sets of 20 spheres
    }
    switch (scene.motion.mode)
    {
    case Motion::descend:
        return {0.5834, 0.3892, 0.0093, 0.5804, 0.0044};
    case Motion::skip:
        return {0.5953, 0.3840, 0.0145, 0.5887, 0.0029};
    case Motion::fall:
    case Motion::granular: // without friction
        break;
    }
    return {0.5951, 0.3620, 0.0130, 0.5896, 0.0035};
}

/// Growth of the error beyond the fitted r S / V: quadratic, the first term that the formula omits.
[[nodiscard]] inline double growthOfError(double radiusTimesAreaOverVolume)
{
    constexpr double kFitted = 0.3;
    return std::pow(std::max(1.0, radiusTimesAreaOverVolume / kFitted), 2);
}

/// Relative scatter, between seeds, of the number of spheres that fit.
[[nodiscard]] inline double scatterOfCount(double count)
{
    return 0.14 / std::sqrt(std::max(1.0, count));
}

} // namespace frostfill
