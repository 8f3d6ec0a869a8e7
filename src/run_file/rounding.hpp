// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
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
    static constexpr int kSpeedBits = 12; ///< of a float's 23 that exact speeds lose

    double grid = 1; ///< of places [mesh unit]
    /// Radii, and places at rest, are kept to the last bit: in a run file. Otherwise as pictures
    /// need them: radii in radiusStep(), speeds in steps of fastest / 255.
    bool exact = true;
    double fastest = 0; ///< speed from which on all are alike, unless exact [mesh unit/s]

    /// Of a coordinate relative to the origin of pictures [grid]; 0 for what is no number.
    [[nodiscard]] std::int64_t place(double coordinate) const;
    [[nodiscard]] std::int64_t radius(double radius) const
    {
        return exact ? std::bit_cast<std::int64_t>(radius) : place(radius / radiusStep() * grid);
    }
    [[nodiscard]] double radiusOf(std::int64_t number) const
    {
        return exact ? std::bit_cast<double>(number) : static_cast<double>(number) * radiusStep();
    }
    [[nodiscard]] std::int64_t speed(float speed) const
    {
        if (exact)
        {
            const auto bits = std::bit_cast<std::uint32_t>(speed);
            const std::uint32_t up = (bits + (1U << (kSpeedBits - 1))) >> kSpeedBits;
            return std::isfinite(speedOf(up)) ? up : bits >> kSpeedBits;
        }
        const double share = fastest > 0 ? static_cast<double>(speed) / fastest : 0;
        return std::lround(255 * std::clamp(share, 0.0, 1.0));
    }
    [[nodiscard]] float speedOf(std::int64_t number) const
    {
        return exact ? std::bit_cast<float>(static_cast<std::uint32_t>(number) << kSpeedBits)
                     : static_cast<float>(static_cast<double>(number) * fastest / 255);
    }
    [[nodiscard]] double radiusStep() const { return grid / 64; } ///< [mesh unit]
};

} // namespace frostfill
