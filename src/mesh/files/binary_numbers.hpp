// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/files/unreadable.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace frostfill
{

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in memory");

/// A number from where it lies, in whatever order its bytes are.
template <typename Number>
[[nodiscard]] Number loadNumber(const char* from, bool bigEndian)
{
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(from, sizeof(Number), bytes.begin());
    if (bigEndian)
    {
        std::reverse(bytes.begin(), bytes.end());
    }
    return std::bit_cast<Number>(bytes);
}

inline void refuseNotFinite(double coordinate, const Place& place)
{
    if (!std::isfinite(coordinate))
    {
        refuseAt(place, "a coordinate is infinite or not a number; export the mesh again");
    }
}

} // namespace frostfill
