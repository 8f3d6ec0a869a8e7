// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/lanes.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

// Half as many lanes in double precision: as many bytes as all in single precision.

namespace frostfill::lanes
{

inline constexpr std::size_t kHalf = kLanes / 2;

using Doubles = double __attribute__((vector_size(8 * kHalf)));
using LongMask = std::int64_t __attribute__((vector_size(8 * kHalf))); ///< all bits, or none
using HalfInts = std::int32_t __attribute__((vector_size(4 * kHalf)));

FROSTFILL_INLINE Doubles select(LongMask mask, Doubles a, Doubles b)
{
    return mask ? a : b;
}

FROSTFILL_INLINE Doubles min(Doubles a, Doubles b)
{
    return b < a ? b : a;
}

FROSTFILL_INLINE Doubles max(Doubles a, Doubles b)
{
    return a < b ? b : a;
}

FROSTFILL_INLINE Doubles absolute(Doubles value)
{
    return select(value < 0.0, -value, value);
}

/// For what an int can hold.
FROSTFILL_INLINE HalfInts floorOf(Doubles value)
{
    const HalfInts towardsZero = __builtin_convertvector(value, HalfInts);
    const LongMask below = value < __builtin_convertvector(towardsZero, Doubles);
    return towardsZero + __builtin_convertvector(below, HalfInts);
}

FROSTFILL_INLINE Doubles root(Doubles value)
{
    Doubles result;
    for (std::size_t i = 0; i < kHalf; ++i)
    {
        result[i] = std::sqrt(value[i]);
    }
    return result;
}

FROSTFILL_INLINE HalfFloats inSingle(Doubles value)
{
    return __builtin_convertvector(value, HalfFloats);
}

/// Points or directions.
struct DoubleVectors
{
    Doubles x, y, z;
};

FROSTFILL_INLINE DoubleVectors cross(const DoubleVectors& a, const DoubleVectors& b)
{
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

FROSTFILL_INLINE Doubles dot(const DoubleVectors& a, const DoubleVectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

} // namespace frostfill::lanes
