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

FROSTFILL_INLINE Floats along(const Vectors& a, const LightWay& way)
{
    return along(a, way.x, way.y, way.z);
}

FROSTFILL_INLINE Floats lightOn(const Vectors& normal)
{
    return lightOf(normal.y, along(normal, kKeyLight), along(normal, kFillLight),
                   along(normal, kBackLight));
}

template <class ValueOf>
FROSTFILL_INLINE Floats eight(ValueOf valueOf)
{
    return Floats{valueOf(0), valueOf(1), valueOf(2), valueOf(3),
                  valueOf(4), valueOf(5), valueOf(6), valueOf(7)};
}

} // namespace frostfill::lanes
