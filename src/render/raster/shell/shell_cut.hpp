// SPDX-License-Identifier: MIT
// How far the shell is from a cutaway.
#pragma once

#include "render/raster/lanes/shading.hpp"
#include "render/raster/shell/shell_raster.hpp"

#include <array>
#include <cstddef>

namespace frostfill::lanes
{

/// How far a point is from the cut in the picture, positive beyond it, where it is `isNear`, which
/// changes by `nearX` and `nearY` from pixel to pixel. [pixel]
FROSTFILL_INLINE Floats pixelsFromCut(const ShellCut& cut, Floats x, Floats y, Floats isNear,
                                      float nearX, float nearY)
{
    const Floats over = cut.orthographic ? all(1) : 1 / isNear;
    const Floats rayX = cut.left + cut.perColumn * x;
    const Floats rayY = cut.bottom + cut.perRow * y;
    std::array<Floats, 2> depth;
    std::array<Floats, 2> slope;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto& [a, b, c, d] = cut.planes[i];
        const Floats beside = a * rayX + b * rayY;
        const Floats ahead = cut.orthographic ? beside + c * isNear : (beside - c) * over;
        const Floats bySideX = cut.orthographic ? all(c * nearX) : -ahead * nearX;
        const Floats bySideY = cut.orthographic ? all(c * nearY) : -ahead * nearY;
        const Floats slopeX = (a * cut.perColumn + bySideX) * over;
        const Floats slopeY = (b * cut.perRow + bySideY) * over;
        depth[i] = ahead + d;
        slope[i] = abs(slopeX) + abs(slopeY);
    }
    const Mask first = depth[0] < depth[1];
    const Floats nearest = select(first, depth[0], depth[1]);
    const Floats steepest = select(nearest > 0, all(cut.steepest), cut.steepestBefore) * over;
    return nearest / min(max(select(first, slope[0], slope[1]), 1e-6F), steepest);
}

} // namespace frostfill::lanes
