// SPDX-License-Identifier: MIT
// What a cutaway leaves of the shell, as in mesh.frag with CUTAWAY.
#pragma once

#include "render/raster/lanes.hpp"
#include "render/raster/shell_raster.hpp"

#include <array>
#include <cstddef>

namespace frostfill::lanes
{

/// What is left ends in a line of its own: how much of the surface there is, and of the line.
struct CutEdge
{
    Floats left, line;
};

/// At a point of the picture. How near it is changes by `nearX` and `nearY` from pixel to pixel.
FROSTFILL_INLINE CutEdge cutEdgeAt(const ShellCut& cut, float lineWidth, Floats x, Floats y,
                                   Floats isNear, float nearX, float nearY)
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
        slope[i] = max(slopeX, -slopeX) + max(slopeY, -slopeY);
    }
    const Mask first = depth[0] < depth[1];
    const Floats steepest = cut.steepest * over;
    const Floats steep = min(max(select(first, slope[0], slope[1]), 1e-6F), steepest);
    const Floats pixels = select(first, depth[0], depth[1]) / steep;
    return {clamped(0.5F - pixels), 0.85F * clamped(1.5F * lineWidth + pixels + 0.5F)};
}

} // namespace frostfill::lanes
