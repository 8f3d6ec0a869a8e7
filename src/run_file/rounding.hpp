// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

#include <cstdint>

namespace frostfill
{

/// The grid to which places of moving spheres are rounded: a power of two, so that a rounded place
/// is a float's exact value, and at least so many in the smallest radius. A run file has the
/// default. [mesh unit]
[[nodiscard]] double gridOf(double smallestRadius, double stepsInARadius = 10000);

/// The numbers of spheres as whole ones, as a stream of frames keeps them.
struct Rounding
{
    double grid = 1; ///< of places [mesh unit]
    /// Radii, and places at rest, are kept to the last bit: in a run file. Otherwise as pictures
    /// need them: radii in radiusStep(), speeds in steps of fastest / 255.
    bool exact = true;
    double fastest = 0; ///< speed from which on all are alike, unless exact [mesh unit/s]

    /// Of a coordinate relative to the origin of pictures [grid]; 0 for what is no number.
    [[nodiscard]] std::int64_t place(double coordinate) const;
    [[nodiscard]] std::int64_t radius(double radius) const;
    [[nodiscard]] double radiusOf(std::int64_t number) const;
    [[nodiscard]] std::int64_t speed(float speed) const;
    [[nodiscard]] float speedOf(std::int64_t number) const;
    [[nodiscard]] double radiusStep() const { return grid / 64; } ///< [mesh unit]
};

} // namespace frostfill
