// SPDX-License-Identifier: MIT
// How spheres look in a point.
#pragma once

#include "render/raster/lanes/shading.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

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

/// What the marks leave of light.
template <Marks marks>
FROSTFILL_INLINE Floats leftOfLight(const SphereSetup& s, const Normals& normals, const Places& at)
{
    if constexpr (marks == Marks::none)
    {
        return all(1);
    }
    Floats left = unmarked(s.look, at.rhoSquared, at.across + at.above);
    if (s.look.stripe > 0)
    {
        left *= unstriped(s.look, dot(normals, s.stripe));
    }
    return marks == Marks::print ? left * unlined(s.look, at.rhoSquared, s.outline) : left;
}

FROSTFILL_INLINE Words inBytes(const Vectors& colour)
{
    return byteOf(colour.x) | byteOf(colour.y) << 8 | byteOf(colour.z) << 16 | 0xff000000U;
}

/// With gloss and haze.
template <Marks marks>
FROSTFILL_INLINE Words finished(const SphereSetup& s, const Normals& normals, const Vectors& lit)
{
    if constexpr (marks == Marks::none)
    {
        return inBytes(lit + s.look.haze);
    }
    return inBytes(lit + s.look.haze + glossOf(s.look, dot(normals, s.highlight)));
}

/// Multiplies the light of the sky, and that of the lamp, by the share that neighbours let through.
/// `facing`: the cosine of the angle between normal and lamp.
template <bool withLamp>
FROSTFILL_INLINE void takeLight(const SphereRaster::Lighting& l, const Normals& normals,
                                Floats facing, Floats& sky, Floats& lamp)
{
    for (std::size_t i = 0; i < l.count; ++i)
    {
        const SphereRaster::Lighting::Occluder& o = l.occluders[i];
        const Floats along = dot(normals, o.way);
        const Floats squared = o.squared - 2 * along;
        sky *= skyPast(along, o.radius, squared);
        if (withLamp && o.ahead > -1)
        {
            lamp *= lampPast(o.ahead - facing, o.radius, squared);
        }
    }
}

/// The look of all styles but the studio, with or without ambient occlusion.
template <bool occluded>
struct InClean
{
    const SphereSetup& s;
    const SphereRaster::Lighting* l;

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& at) const
    {
        Floats light = lightFrom(dot(normals, s.up), dot(normals, s.key), dot(normals, s.fill),
                                 dot(normals, s.back)) *
                       lightNearRim(at.w);
        if constexpr (occluded)
        {
            Floats sky = all(l->sky);
            Floats lamp{};
            takeLight<false>(*l, normals, lamp, sky, lamp);
            light *= sky;
        }
        return finished<marks>(s, normals,
                               s.look.tint * (light * leftOfLight<marks>(s, normals, at)));
    }
};

struct InStudio
{
    const SphereSetup& s;
    const SphereRaster::Lighting& l;

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& at) const
    {
        Floats sky = all(l.sky);
        Floats lamp = all(l.lamp);
        const Floats facing = dot(normals, l.towardsLamp);
        takeLight<true>(l, normals, facing, sky, lamp);
        const Vectors lit =
            inStudio(s.look.tint, dot(normals, l.up), facing, dot(normals, l.gloss), sky, lamp);
        return finished<marks>(s, normals, lit * leftOfLight<marks>(s, normals, at));
    }
};

/// Not how it looks, but where it faces; it leaves its identity too.
struct InSurfaces
{
    const SphereRaster::Surface& surface;

    template <Marks marks>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& /*at*/) const
    {
        const Vectors facing = {dot(normals, surface.right), dot(normals, surface.up),
                                dot(normals, surface.towards)};
        return inBytes(0.5F * kWhite + all(0.5F * kWhite) * facing);
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
    const bool marked = s.look.gloss + s.look.ring + s.look.hatch + s.look.stripe > 0;
    if (drawn.surface != nullptr)
    {
        visit(s, InSurfaces{*drawn.surface}, None{});
    }
    else if (drawn.studio && drawn.lighting != nullptr)
    {
        marked ? visit(s, InStudio{s, *drawn.lighting}, State{})
               : visit(s, InStudio{s, *drawn.lighting}, None{});
    }
    else
    {
        const auto inClean = [&](const auto& look) __attribute__((always_inline))
        {
            drawn.print ? visit(s, look, Print{})
            : marked    ? visit(s, look, State{})
                        : visit(s, look, None{});
        };
        drawn.lighting != nullptr ? inClean(InClean<true>{s, drawn.lighting})
                                  : inClean(InClean<false>{s, nullptr});
    }
}

} // namespace frostfill::lanes
