// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"

#include <frostfill/packing.hpp>

#include <cmath>
#include <cstddef>

namespace frostfill::test
{

/// Spheres in random places of a cube from -1 to 1, which overlap. The largest is `ratio` times as
/// large as the smallest, and most are small.
inline Packing mixedSpheres(std::size_t count, double largest, double ratio)
{
    Packing packing;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        const auto coordinate = [&](std::uint64_t axis)
        { return 2 * uniformRandom(11, k, axis) - 1; };
        packing.centres.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        packing.radii.push_back(largest * std::pow(ratio, -std::sqrt(uniformRandom(11, k, 3))));
    }
    packing.atRest.assign(count, true);
    return packing;
}

} // namespace frostfill::test
