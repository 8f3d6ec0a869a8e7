// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{

// Equal spheres of radius r that fill an object of volume V and surface S take about
// phi (V - c r S): random packing far from walls takes the share phi of the room, and a wall takes
// away a layer of c radii. How many spheres fit is told with one pair for all.
inline constexpr double kPackingFraction = 0.586; ///< phi
inline constexpr double kWallLayer = 0.38;        ///< c

/// The same for one way to fill, fitted to cube, sphere, torus, human and spot (the cow) at
/// r S / V = 0.15 and 0.3, and what remains.
struct PackingCalibration
{
    double fraction;     ///< phi
    double wallLayer;    ///< c
    double formulaError; ///< largest error of (N v / phi + c r S) / V over these fillings
    double ruleFraction; ///< phi of the two-radius rule
    double ruleError;    ///< largest error of (2 N(r/2) v(r/2) - N(r) v(r)) / phi / V
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
        return {0.5816, 0.388, 0.0115, 0.5812, 0.0065};
    case Motion::skip:
        return {0.5893, 0.3616, 0.0155, 0.5898, 0.0060};
    case Motion::fall:
        break;
    }
    return {0.5872, 0.3235, 0.0150, 0.5898, 0.0080};
}

/// How far beyond the fitted r S / V an error grows, as the square that the formula leaves out.
[[nodiscard]] inline double growthOfError(double radiusTimesAreaOverVolume)
{
    constexpr double kFitted = 0.3;
    return std::pow(std::max(1.0, radiusTimesAreaOverVolume / kFitted), 2);
}

/// Relative scatter of the number of spheres that fit, between seeds.
[[nodiscard]] inline double scatterOfCount(double count)
{
    return 0.14 / std::sqrt(std::max(1.0, count));
}

} // namespace frostfill
