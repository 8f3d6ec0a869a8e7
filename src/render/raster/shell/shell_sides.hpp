// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/shell/shell_corners.hpp"

#include <array>

namespace frostfill::lanes
{

/// The edges of triangles as ShellRaster::Setup has them, a triangle a lane.
template <class Values>
struct ShellSides
{
    std::array<Values, 3> across, upwards, from, least, share, near;
    std::array<Values, 3> divisors; ///< what the corners' places in the picture are divided by
};

template <class Vertex>
FROSTFILL_INLINE ShellSides<HalfFloats> sidesOf(const Corners<Vertex>& corners)
{
    const std::array<DoubleVectors, 3> at = corners.places();
    const Doubles determinants = dot(at[0], cross(at[1], at[2]));
    const LongMask front = determinants > 0.0;
    const Doubles size = absolute(determinants);
    ShellSides<HalfFloats> sides;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const DoubleVectors& from = at[(i + 1) % 3];
        const DoubleVectors& to = at[(i + 2) % 3];
        // The other triangle at the edge has these numbers but for the sign: no gap between them.
        const DoubleVectors side = cross(from, to);
        const Doubles lengths = max(root(side.x * side.x + side.y * side.y), Doubles{} + 1e-30);
        const auto inwards = [&](Doubles value) __attribute__((always_inline))
        {
            return inSingle(select(front, value, -value) / lengths);
        };
        sides.across[i] = inwards(side.x);
        sides.upwards[i] = inwards(side.y);
        sides.from[i] = inwards(side.z);
        const LongMask swapped =
            (to.x < from.x) |
            (~(from.x < to.x) & ((to.y < from.y) | (~(from.y < to.y) & (to.z < from.z))));
        sides.least[i] = inSingle(select(swapped ^ front, Doubles{} - double{1e-30F}, Doubles{}));
        const Doubles shares = lengths / size;
        const Doubles heights = corners.gather(i, [](const Vertex& v) { return v.height; });
        sides.share[i] = inSingle(shares);
        sides.near[i] = inSingle(shares * heights);
        sides.divisors[i] = inSingle(at[i].z);
    }
    return sides;
}

FROSTFILL_INLINE ShellSides<Floats> joined(const ShellSides<HalfFloats>& lower,
                                           const ShellSides<HalfFloats>& upper)
{
    return {joined(lower.across, upper.across),    joined(lower.upwards, upper.upwards),
            joined(lower.from, upper.from),        joined(lower.least, upper.least),
            joined(lower.share, upper.share),      joined(lower.near, upper.near),
            joined(lower.divisors, upper.divisors)};
}

} // namespace frostfill::lanes
