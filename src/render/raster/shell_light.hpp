// SPDX-License-Identifier: MIT
// Light on the shell, eight normals at once.
#pragma once

#include "render/raster/lanes.hpp"

#include <cstddef>

namespace frostfill::lanes
{

/// Directions.
struct Vectors
{
    Floats x, y, z;
};

FROSTFILL_INLINE Floats dot(const Vectors& a, const Vectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FROSTFILL_INLINE Floats along(const Vectors& a, float x, float y, float z)
{
    return a.x * x + a.y * y + a.z * z;
}

FROSTFILL_INLINE Floats lightOn(const Vectors& normal)
{
    return lightOf(normal.y, along(normal, -0.424F, 0.636F, 0.645F),
                   along(normal, 0.802F, 0.134F, 0.582F), along(normal, 0.258F, 0.602F, -0.756F));
}

template <class ValueOf>
FROSTFILL_INLINE Floats eight(ValueOf valueOf)
{
    return Floats{valueOf(0), valueOf(1), valueOf(2), valueOf(3),
                  valueOf(4), valueOf(5), valueOf(6), valueOf(7)};
}

} // namespace frostfill::lanes
