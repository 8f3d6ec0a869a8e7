// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "scene/radius_distribution.hpp"
#include "simulation/release/tolerances.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The largest radius of each class, ascending: the smallest of all, then by a constant ratio.
[[nodiscard]] std::vector<double> classLimits(const RadiusDistribution& radii);

/// Numbers in [0, 1) any run of which is spread evenly: of n in a row, every interval has its share
/// within about two, where independent ones would miss it by the root of n. Multiples of the golden
/// ratio, from a random start [Niederreiter 1992].
[[nodiscard]] inline double evenRandom(std::uint64_t seed, std::uint64_t number)
{
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15; // 2^64 (sqrt(5) - 1) / 2
    const auto start =
        static_cast<std::uint64_t>(std::ldexp(uniformRandom(seed, 0, kRadiusDraw), 53)) << 11;
    return std::ldexp(static_cast<double>((start + number * kGolden) >> 11), -53);
}

} // namespace frostfill
