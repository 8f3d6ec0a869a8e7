// SPDX-License-Identifier: MIT
// How spheres look in a point, and how their rows are drawn: whole, and what a cutaway leaves of
// them, as in sphere.frag and common.glsl.
#include "render/raster/spheres/sphere_raster.hpp"

#include "render/raster/lanes/shading.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = SphereRaster::Setup;
using Cut = SphereRaster::Cut;
using Drawn = SphereRaster::Drawn;

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

FROSTFILL_INLINE Floats dot(const Normals& normals, const Setup::Slope& slope)
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
FROSTFILL_INLINE Floats leftOfLight(const Setup& s, const Normals& normals, const Places& at)
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
FROSTFILL_INLINE Words finished(const Setup& s, const Normals& normals, const Vectors& lit)
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
    const Setup& s;
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
    const Setup& s;
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
    const Setup s = drawn.setup; // so that the tile cannot be part of it
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

template <int samples, Marks marks, class Look>
FROSTFILL_INLINE void drawRows(const Setup& s, const Look& look, const PixelRectangle& rows,
                               const TilePart& part, SampleTile& tile)
{
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float dy = static_cast<float>(part.bottom + y) + 0.5F - s.y;
        const float aboveRow = s.aboveY * dy;
        const float alongRow = s.along + s.alongY * dy;
        for (int x = rows.left; x < rows.right; x += kLanes)
        {
            const Floats dx = static_cast<float>(part.left + x) + 0.5F - s.x + iota();
            const Floats acrossK = s.acrossX * dx;
            const Floats aboveK = aboveRow + s.aboveX * dx;
            const Floats along = alongRow + s.alongX * dx;
            const Floats over = 1 / along;
            const Floats across = acrossK * over;
            const Floats above = aboveK * over;
            const Floats rhoSquared = across * across + above * above;
            const Floats w = root(max(1 - rhoSquared, 0));
            const Floats q = along * s.nearScale;
            const Floats nearness = q + (q * s.radiusOverDistance + s.rise) * w;
            const int first = y * kTileEdge + x;
            const auto at = static_cast<std::size_t>(first);
            std::array<Mask, samples> seen;
            Mask seenAtAll{};
            for (std::size_t k = 0; k < samples; ++k)
            {
                const Floats a = acrossK + s.acrossAt[k];
                const Floats b = aboveK + s.aboveAt[k];
                const Floats c = along + s.alongAt[k];
                float* held = tile.inverseDepth[k].data() + at;
                const auto before = load<Floats>(held);
                seen[k] = (a * a + b * b < c * c) & (c > s.leastAlong) & (c < s.mostAlong) &
                          (nearness > before);
                seenAtAll |= seen[k];
                store(select(seen[k], nearness, before), held);
            }
            if (!any(seenAtAll))
            {
                continue;
            }
            const Floats t = 1 / (1 + s.radiusOverDistance * w);
            const Words rgba = look.template shaded<marks>(
                Normals{(s.radiusOverDistance + w) * t, across * t, above * t},
                Places{across, above, rhoSquared, w});
            for (std::size_t k = 0; k < samples; ++k)
            {
                std::uint32_t* shown = tile.colour[k].data() + at;
                store(select(seen[k], rgba, load<Words>(shown)), shown);
            }
            putIdentity(look, seen[0], at, tile);
        }
    }
}

// What a cutaway leaves of a sphere: a sample has the depth and the colour of its own place, for a
// cut runs through the middle of pixels.

FROSTFILL_INLINE CutMeeting meet(const Cut& cut, const Places& at, Floats enter, Floats leave)
{
    std::array<Floats, 2> start;
    std::array<Floats, 2> growth;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Cut::Plane& plane = cut.planes[i];
        start[i] = plane.start + plane.startAcross * at.across + plane.startAbove * at.above;
        growth[i] = plane.growth + plane.growthAcross * at.across + plane.growthAbove * at.above;
    }
    return meetCut(start[0], growth[0], start[1], growth[1], enter, leave);
}

/// The normals where a ray meets a sphere.
FROSTFILL_INLINE Normals normalsAt(const Setup& s, const Cut& cut, const Places& at,
                                   const CutMeeting& met)
{
    if (cut.orthographic)
    {
        return {-met.t / cut.radius, at.across, at.above};
    }
    // On the sphere itself nothing is subtracted that nearly cancels.
    const Floats onCut = (1 - met.t * (cut.shrink * cut.shrink)) / s.radiusOverDistance;
    const Floats onSphere = (s.radiusOverDistance + at.w) * met.t;
    return {select(met.capped, onCut, onSphere), at.across * met.t, at.above * met.t};
}

/// What a look shows on the cut.
template <class Look>
FROSTFILL_INLINE Words shownOnCut(const Setup& s, const Cut& cut, const Look& look,
                                  const Normals& normals, const Places& at, const CutMeeting& met)
{
    const auto ofPlane = [&](auto valueOf) __attribute__((always_inline))
    {
        return select(met.onSecond, all(valueOf(cut.planes[1])), all(valueOf(cut.planes[0])));
    };
    if constexpr (std::is_same_v<Look, InSurfaces>)
    {
        return select(met.onSecond, Words{} + look.surface.ofCut[1],
                      Words{} + look.surface.ofCut[0]);
    }
    else
    {
        const Floats heightSquared =
            ofPlane([](const Cut::Plane& plane) { return plane.heightSquared; });
        const Floats squared = normals.axis * normals.axis +
                               (cut.shrink * cut.shrink) *
                                   (normals.right * normals.right + normals.above * normals.above);
        const Floats light = ofPlane([](const Cut::Plane& plane) { return plane.light; });
        return inBytes(onCut(s.look, light, squared, heightSquared, at.across + at.above));
    }
}

/// What is seen of kLanes samples.
struct Seen
{
    Floats nearness;
    Words colour;
    Mask mask;
};

template <Marks marks, class Look>
FROSTFILL_INLINE Seen seenThrough(const Setup& s, const Cut& cut, const Look& look, Floats acrossK,
                                  Floats aboveK, Floats along, Floats before)
{
    const Floats over = 1 / along;
    Places at{acrossK * over, aboveK * over, {}, {}};
    at.rhoSquared = at.across * at.across + at.above * at.above;
    at.w = root(max(1 - at.rhoSquared, 0));
    const Floats rise = (cut.orthographic ? cut.radius : s.radiusOverDistance) * at.w;
    const Floats enter = cut.orthographic ? -rise : 1 / (1 + rise);
    const Floats leave = cut.orthographic ? rise : 1 / (1 - rise);
    const CutMeeting met = meet(cut, at, enter, leave);
    const Floats q = along * s.nearScale;
    Seen seen;
    seen.nearness = cut.orthographic ? q - met.t : q / met.t;
    seen.mask = (at.rhoSquared < 1) & (along > s.leastAlong) & (along < s.mostAlong) & met.isThere &
                (seen.nearness > before);
    if (!any(seen.mask))
    {
        return seen;
    }
    const Normals normals = normalsAt(s, cut, at, met);
    seen.colour = look.template shaded<marks>(normals, at);
    if (any(seen.mask & met.capped))
    {
        seen.colour = select(met.capped, shownOnCut(s, cut, look, normals, at, met), seen.colour);
    }
    return seen;
}

template <int samples, Marks marks, class Look>
FROSTFILL_INLINE void drawRows(const Setup& s, const Cut& cut, const Look& look,
                               const PixelRectangle& rows, const TilePart& part, SampleTile& tile)
{
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float dy = static_cast<float>(part.bottom + y) + 0.5F - s.y;
        for (int x = rows.left; x < rows.right; x += kLanes)
        {
            const Floats dx = static_cast<float>(part.left + x) + 0.5F - s.x + iota();
            const Floats acrossK = s.acrossX * dx;
            const Floats aboveK = s.aboveY * dy + s.aboveX * dx;
            const Floats along = s.along + s.alongY * dy + s.alongX * dx;
            const int first = y * kTileEdge + x;
            const auto at = static_cast<std::size_t>(first);
            for (std::size_t k = 0; k < samples; ++k)
            {
                float* held = tile.inverseDepth[k].data() + at;
                const auto before = load<Floats>(held);
                const Seen seen =
                    seenThrough<marks>(s, cut, look, acrossK + s.acrossAt[k], aboveK + s.aboveAt[k],
                                       along + s.alongAt[k], before);
                if (!any(seen.mask))
                {
                    continue;
                }
                store(select(seen.mask, seen.nearness, before), held);
                std::uint32_t* shown = tile.colour[k].data() + at;
                store(select(seen.mask, seen.colour, load<Words>(shown)), shown);
                putIdentity(look, seen.mask, at, tile);
            }
        }
    }
}

template <int samples>
FROSTFILL_INLINE void drawAny(const Drawn& drawn, const PixelRectangle& rows, const TilePart& part,
                              SampleTile& tile)
{
    withLook(
        drawn, [&](const Setup& s, const auto& look, auto marks) __attribute__((always_inline)) {
            constexpr Marks kMarks = decltype(marks)::value;
            if (drawn.cut == nullptr)
            {
                drawRows<samples, kMarks>(s, look, rows, part, tile);
                return;
            }
            const Cut cut = *drawn.cut;
            drawRows<samples, kMarks>(s, cut, look, rows, part, tile);
        });
}

} // namespace

void SphereRaster::draw(const SphereInstance& sphere, const PixelRectangle& pixels,
                        const TilePart& part, SampleTile& tile, const SphereLight* light) const
{
    const PixelRectangle rows = part.within(pixels);
    const CutShare share = leftOf(sphere);
    Axes axes;
    Setup setup;
    if (rows.empty() || share == CutShare::nothing || !setUp(sphere, axes, setup))
    {
        return;
    }
    Lighting lighting;
    Surface surface;
    Cut cut;
    Drawn drawn{setup, nullptr, nullptr, nullptr, print_, studio_};
    if (light != nullptr)
    {
        setLighting(*light, axes, lighting);
        drawn.lighting = &lighting;
    }
    if (surfaces_)
    {
        surface = surfaceOf(sphere, axes);
        drawn.surface = &surface;
    }
    if (share == CutShare::part)
    {
        setCut(sphere, axes, cut);
        drawn.cut = &cut;
    }
    inLanes([&]() __attribute__((always_inline)) {
        samples_ > 1 ? drawAny<kMaxTileSamples>(drawn, rows, part, tile)
                     : drawAny<1>(drawn, rows, part, tile);
    });
}

void SphereRaster::setCut(const SphereInstance& sphere, const Axes& axes, Cut& cut) const
{
    const glm::vec3 centre = centreOf(sphere);
    cut.orthographic = grid_.orthographic;
    cut.radius = sphere.radius;
    cut.shrink = axes.shrink;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const glm::vec3 normal(uniforms_.cutPlanes[i]);
        const float offset = uniforms_.cutPlanes[i].w;
        const float across = sphere.radius * axes.shrink * glm::dot(normal, axes.right);
        const float above = sphere.radius * axes.shrink * glm::dot(normal, axes.above);
        const float along = glm::dot(normal, centre);
        const float height = (along + offset) / sphere.radius;
        cut.planes[i] = grid_.orthographic
                            ? Cut::Plane{along + offset, across, above, -normal.z, 0, 0, {}, {}}
                            : Cut::Plane{offset, 0,     0,  along * axes.shrink * axes.shrink,
                                         across, above, {}, {}};
        cut.planes[i].heightSquared = height * height;
        cut.planes[i].light = lightOn({all(normal.x), all(normal.y), all(normal.z)})[0];
    }
}

SphereRaster::Surface SphereRaster::surfaceOf(const SphereInstance& sphere, const Axes& axes) const
{
    const auto bytesOf = [](const glm::vec3& normal)
    {
        const Vectors facing = {all(normal.x), all(normal.y), all(normal.z)};
        return inBytes(0.5F * kWhite + all(0.5F * kWhite) * facing)[0];
    };
    Surface surface{axes.slope({1, 0, 0}), axes.slope({0, 1, 0}), axes.slope({0, 0, 1}), 0, {}};
    for (std::size_t c = 0; c < 4; ++c)
    {
        surface.identity |= std::uint32_t{sphere.colour[c]} << (8 * c);
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
        surface.ofCut[i] = bytesOf(glm::vec3(uniforms_.cutPlanes[i]));
    }
    return surface;
}

} // namespace frostfill
