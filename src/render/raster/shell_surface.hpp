// SPDX-License-Identifier: MIT
// How the shell looks in a point, as in mesh.frag.
#pragma once

#include "render/raster/lanes.hpp"
#include "render/raster/shell_rows.hpp"

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
    facing = max(towards, -towards);
    const auto along = [&](const LightWay& way) __attribute__((always_inline))
    {
        return (nx * way.x + ny * way.y + nz * way.z) * length;
    };
    return 0.55F +
           0.45F * lightOf(ny * length, along(kKeyLight), along(kFillLight), along(kBackLight));
}

/// Others' creases are not drawn from here on, where their distance is 1 at most.
inline constexpr float kCreaseEnd = 0.9F;

/// How far from its middle a line is seen. [pixel]
inline float reachOf(float lineWidth)
{
    return lineWidth + 0.5F;
}

/// How much of it the surface covers that faces the viewer so far.
template <class Value>
FROSTFILL_INLINE Floats shareOf(Value density, Value rimDensity, Floats facing)
{
    return min(density + rimDensity * ((1 - facing) * (1 - facing)), 0.85F);
}

/// How much of it a hatched surface covers.
FROSTFILL_INLINE Floats hatchedShare(const ShellRaster::Setup& s, const ShellRows& f, Floats x,
                                     Floats y)
{
    const Floats phase = (x + s.hatch * y) * (1 / f.hatchPeriod) + f.hatchShift;
    return min(s.density * (0.35F + stripes(phase, 0.4F, 1.41F / f.hatchPeriod)), 0.85F);
}

/// How much the outline of a smooth surface covers.
template <class Value>
FROSTFILL_INLINE Floats contourOf(Value contour, Value pixelsOfFacing, Floats facing, float reach)
{
    return contour * (1 - smoothstep(0.3F, 0.5F, facing)) *
           clamped(reach - 0.5F * facing * pixelsOfFacing);
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
        facing = max(facing, -facing);
        surface.light = b0 * s.light[0] + b1 * s.light[1] + b2 * s.light[2];
    }
    else
    {
        surface.light = curved(s, f, x, y, b0, b1, b2, facing);
    }
    surface.share =
        s.hatch != 0 ? hatchedShare(s, f, x, y) : shareOf(s.density, s.rimDensity, facing);
    if constexpr (!lines)
    {
        return {surface, Floats{}};
    }
    const float reach = reachOf(f.lineWidth);
    Floats line{};
    if (s.edges)
    {
        line = max(s.strength[0] * clamped(reach - d0),
                   max(s.strength[1] * clamped(reach - d1), s.strength[2] * clamped(reach - d2)));
    }
    if (s.contour > 0)
    {
        line = max(line, contourOf(s.contour, s.pixelsOfFacing, facing, reach));
    }
    if (s.crease > 0)
    {
        const Floats off =
            b0 * s.creaseDistance[0] + b1 * s.creaseDistance[1] + b2 * s.creaseDistance[2];
        line = max(line, s.crease * (1 - smoothstep(0.6F, kCreaseEnd, off)) *
                             clamped(reach - off * s.pixelsOfCrease));
    }
    return {surface, line};
}

/// Of what is drawn in a point: how much of it is film, and how much line. Lines lie over the film;
/// in print they are a part of it that is denser.
FROSTFILL_INLINE void putLineInFilm(bool print, Floats& film, Floats& line)
{
    if (print)
    {
        const Floats covered = max(film, line);
        film = covered * (1 - line);
        line = covered * line;
    }
    else
    {
        film *= 1 - line;
    }
}

} // namespace frostfill::lanes
