// SPDX-License-Identifier: MIT
// How the shell looks in a point.
#pragma once

#include "render/raster/lanes/shading.hpp"
#include "render/raster/shell/shell_rows.hpp"

#include <utility>

namespace frostfill::lanes
{

struct SurfaceSample
{
    Floats share;
    Floats light;
};

/// The light on a point of the surface, and how far it faces the viewer, from the normal there.
FROSTFILL_INLINE Floats curved(const ShellRaster::Setup& s, const ShellRows& f, Floats x, Floats y,
                               Floats b0, Floats b1, Floats b2, Floats& facing)
{
    const Floats nx = b0 * s.normals[0].x + b1 * s.normals[1].x + b2 * s.normals[2].x;
    const Floats ny = b0 * s.normals[0].y + b1 * s.normals[1].y + b2 * s.normals[2].y;
    const Floats nz = b0 * s.normals[0].z + b1 * s.normals[1].z + b2 * s.normals[2].z;
    const Floats length = 1 / root(max(nx * nx + ny * ny + nz * nz, 1e-12F));
    const Floats rayX = f.left + f.perColumn * x;
    const Floats rayY = f.bottom + f.perRow * y;
    const Floats towards =
        (nz - nx * rayX - ny * rayY) * length / root(rayX * rayX + (1 + rayY * rayY));
    facing = abs(towards);
    return lightInFilm(lightOn({nx * length, ny * length, nz * length}));
}

/// Of the surface: how much it covers and the light on it; and how much its lines cover of that.
template <bool lines>
FROSTFILL_INLINE std::pair<SurfaceSample, Floats>
surfaceAndLine(const ShellRaster::Setup& s, const ShellRows& f, Floats x, Floats y, Floats d0,
               Floats d1, Floats d2)
{
    const Floats l0 = s.share[0] * d0;
    const Floats l1 = s.share[1] * d1;
    const Floats l2 = s.share[2] * d2;
    const Floats over = 1 / max(l0 + l1 + l2, 1e-12F);
    const Floats b0 = l0 * over;
    const Floats b1 = l1 * over;
    const Floats b2 = l2 * over;
    SurfaceSample surface;
    Floats facing;
    if (s.flat)
    {
        facing = b0 * s.facing[0] + b1 * s.facing[1] + b2 * s.facing[2];
        facing = abs(facing);
        surface.light = b0 * s.light[0] + b1 * s.light[1] + b2 * s.light[2];
    }
    else
    {
        surface.light = curved(s, f, x, y, b0, b1, b2, facing);
    }
    surface.share = filmShare(all(s.density), all(s.rimDensity), facing);
    if constexpr (!lines)
    {
        return {surface, Floats{}};
    }
    Floats line{};
    if (s.edges)
    {
        line = max(
            s.strength[0] * onLine(d0, f.lineWidth),
            max(s.strength[1] * onLine(d1, f.lineWidth), s.strength[2] * onLine(d2, f.lineWidth)));
    }
    if (s.contour > 0)
    {
        line = max(line, contourLine(all(s.contour), facing, all(s.pixelsOfFacing), f.lineWidth));
    }
    if (s.crease > 0)
    {
        const Floats away =
            b0 * s.creaseDistance[0] + b1 * s.creaseDistance[1] + b2 * s.creaseDistance[2];
        line = max(line, creaseLine(all(s.crease), away, all(s.pixelsOfCrease), f.lineWidth));
    }
    return {surface, line};
}

} // namespace frostfill::lanes
