// SPDX-License-Identifier: MIT
// Spheres that a cutaway leaves a part of, as in sphere.frag and common.glsl with CUTAWAY.
#include "render/raster/spheres/sphere_looks.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = SphereRaster::Setup;
using Cut = SphereRaster::Cut;
using Drawn = SphereRaster::Drawn;

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
    Floats isNear;
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
    seen.isNear = cut.orthographic ? q - met.t : q / met.t;
    seen.mask = (at.rhoSquared < 1) & (along > s.leastAlong) & (along < s.mostAlong) & met.isThere &
                (seen.isNear > before);
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
                store(select(seen.mask, seen.isNear, before), held);
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
            const Cut cut = *drawn.cut;
            drawRows<samples, decltype(marks)::value>(s, cut, look, rows, part, tile);
        });
}

} // namespace

void drawCutSphere(int samples, const Drawn& drawn, const PixelRectangle& rows,
                   const TilePart& part, SampleTile& tile)
{
    inLanes([&]() __attribute__((always_inline)) {
        samples > 1 ? drawAny<kMaxTileSamples>(drawn, rows, part, tile)
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
