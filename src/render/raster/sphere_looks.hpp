// SPDX-License-Identifier: MIT
// How spheres look in a point, as in sphere.frag, which has what is behind these numbers.
#pragma once

#include "render/framing/lamp.hpp"
#include "render/raster/lanes.hpp"
#include "render/raster/sphere_raster.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace frostfill::lanes
{

using SphereSetup = SphereRaster::Setup;

/// What of a sphere's marks is drawn: nothing, those of its state, or for print an outline too.
enum class Marks
{
    none,
    state,
    print,
};

/// Normals, as slopes take them.
struct Normals
{
    Floats axis, right, above;
};

FROSTFILL_INLINE Floats dot(const Normals& normals, const SphereSetup::Slope& slope)
{
    return normals.axis * slope.axis + normals.right * slope.right + normals.above * slope.above;
}

/// Where on the disc that is seen: the two coordinates, 0 in its middle, with rho^2 and w.
struct Places
{
    Floats across, above, rhoSquared, w;
};

FROSTFILL_INLINE Floats power16(Floats value)
{
    value *= value;
    value *= value;
    value *= value;
    return value * value;
}

FROSTFILL_INLINE Floats power32(Floats value)
{
    return power16(value * value);
}

FROSTFILL_INLINE Floats hatchAt(const SphereSetup& s, const Places& at)
{
    return s.hatch * stripes((at.across + at.above) * 1.3F + 0.25F, SphereRaster::kHatchShare,
                             s.pixel * 1.84F);
}

/// What the marks leave of the light.
template <Marks marks>
FROSTFILL_INLINE Floats unmarked(const SphereSetup& s, const Places& at)
{
    const Floats ring = clamped((at.rhoSquared - 0.76F) * (1 / (2 * s.pixel + 0.02F)) + 0.5F);
    const Floats left = 1 - s.ring * ring - hatchAt(s, at);
    if constexpr (marks == Marks::print)
    {
        const Floats fromRim = (1 - root(at.rhoSquared)) * (1 / s.pixel);
        return left * (1 - 0.8F * clamped(s.outline - fromRim + 0.5F));
    }
    return left;
}

FROSTFILL_INLINE Words inBytes(Floats red, Floats green, Floats blue)
{
    return byteOf(red) | byteOf(green) << 8 | byteOf(blue) << 16 | 0xff000000U;
}

struct InClean
{
    const SphereSetup& s;

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& at) const
    {
        Floats light = lightOf(dot(normals, s.up), dot(normals, s.key), dot(normals, s.fill),
                               dot(normals, s.back)) *
                       (0.64F + 0.36F * min(1.7F * at.w, 1));
        Floats gloss{};
        if constexpr (marks != Marks::none)
        {
            gloss = power32(max(dot(normals, s.highlight), 0)) * s.gloss;
            light *= unmarked<marks>(s, at);
        }
        return inBytes(s.tint[0] * light + s.haze[0] + gloss, s.tint[1] * light + s.haze[1] + gloss,
                       s.tint[2] * light + s.haze[2] + gloss);
    }
};

struct InStudio
{
    const SphereSetup& s;
    const SphereRaster::Lighting& l;

    /// Multiplies by what neighbours let through of the sky and of the lamp.
    FROSTFILL_INLINE void takeLight(const Normals& normals, Floats facing, Floats& sky,
                                    Floats& lamp) const
    {
        for (std::size_t i = 0; i < l.count; ++i)
        {
            const SphereRaster::Lighting::Occluder& o = l.occluders[i];
            const Floats along = dot(normals, o.way);
            const Floats squared = o.squared - 2 * along;
            const Floats share = clamped(0.5F * o.radius * (along + (o.radius - 1)) / squared);
            sky *= 1 - 0.85F * share * root(share);
            if (o.ahead > -1)
            {
                const Floats ahead = o.ahead - facing;
                const Floats beside = root(max(squared - ahead * ahead, 0));
                const Floats hidden = clamped(
                    0.5F + (o.radius - beside) / (2 * kLampSoftness * max(ahead, 0) + 0.04F));
                lamp *= select(ahead > 0, 1 - hidden, all(1));
            }
        }
    }

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& at) const
    {
        Floats sky = all(l.sky);
        Floats lamp = all(l.lamp);
        const Floats facing = dot(normals, l.towardsLamp);
        takeLight(normals, facing, sky, lamp);
        const Floats fromSky = (0.5F + 0.16F * dot(normals, l.up)) * sky;
        const Floats key = 0.74F * max(facing, 0) * lamp;
        const Floats shine = power16(max(dot(normals, l.gloss), 0)) * (25.5F * lamp);
        const Floats returned = 0.25F * (1 - sky) * (1.0F / 255);
        Floats left = all(1);
        Floats gloss{};
        if constexpr (marks != Marks::none)
        {
            gloss = power32(max(dot(normals, s.highlight), 0)) * s.gloss;
            left = unmarked<marks>(s, at);
        }
        const auto channel = [&](std::size_t c) __attribute__((always_inline))
        {
            const float tint = s.tint[c];
            const Floats ambient = fromSky * (0.96F * tint + 10.2F) * (1 + returned * tint);
            return (ambient + tint * key + shine) * left + s.haze[c] + gloss;
        };
        return inBytes(channel(0), channel(1), channel(2));
    }
};

/// Not how it looks, but where it faces; it leaves its identity too.
struct InSurfaces
{
    const SphereRaster::Surface& surface;

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& /*at*/) const
    {
        const auto channel = [&](const SphereSetup::Slope& way) __attribute__((always_inline))
        {
            return 127.5F + 127.5F * dot(normals, way);
        };
        return inBytes(channel(surface.right), channel(surface.up), channel(surface.towards));
    }
};

/// Leaves whose surface it is, where that is drawn.
template <class Look>
FROSTFILL_INLINE void putIdentity(const Look& look, Mask seen, std::size_t at, SampleTile& tile)
{
    if constexpr (std::is_same_v<Look, InSurfaces>)
    {
        std::uint32_t* shown = tile.colour[SphereRaster::kIdentities].data() + at;
        store(select(seen, Words{} + look.surface.identity, load<Words>(shown)), shown);
    }
}

/// Calls visit(setup, look, integral constant of the marks) for what a sphere is drawn with.
template <class Visit>
FROSTFILL_INLINE void withLook(const SphereRaster::Drawn& drawn, Visit visit)
{
    using None = std::integral_constant<Marks, Marks::none>;
    using State = std::integral_constant<Marks, Marks::state>;
    using Print = std::integral_constant<Marks, Marks::print>;
    const SphereSetup s = drawn.setup; // so that the tile cannot be part of it
    const bool marked = s.gloss + s.ring + s.hatch > 0;
    if (drawn.surface != nullptr)
    {
        visit(s, InSurfaces{*drawn.surface}, None{});
    }
    else if (drawn.print)
    {
        visit(s, InClean{s}, Print{});
    }
    else if (drawn.lighting != nullptr)
    {
        marked ? visit(s, InStudio{s, *drawn.lighting}, State{})
               : visit(s, InStudio{s, *drawn.lighting}, None{});
    }
    else
    {
        marked ? visit(s, InClean{s}, State{}) : visit(s, InClean{s}, None{});
    }
}

} // namespace frostfill::lanes
