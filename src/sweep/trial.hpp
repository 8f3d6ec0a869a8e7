// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/plan.hpp>

#include <optional>

namespace frostfill
{

/// Time goes with the number of spheres to a power between these.
constexpr double kMinPower = 0.9;
constexpr double kLargestPower = 1.7;

/// Seconds of processor time before the first picture, and for each.
struct PictureTimes
{
    double before = 0;
    double each = 0;
};

/// By what many pictures take beyond a few of them.
[[nodiscard]] PictureTimes timesOf(double fewSeconds, double few, double manySeconds, double many);

/// A run that was done, small, and what it took.
struct Trial
{
    double spheres = 0;
    PictureTimes time;
    double pictureBytes = 0;
    double otherBytes = 0;
};

/// Returns what a run with so many spheres and pictures takes, but for its memory. With `smaller`
/// both trials are models of it with fewer spheres, and their times are extrapolated.
[[nodiscard]] Cost costFrom(const Trial& trial, const std::optional<Trial>& smaller, double spheres,
                            double pictures);

} // namespace frostfill
