// SPDX-License-Identifier: MIT
#include "render/raster/sphere_raster.hpp"

#include "render/framing/lamp.hpp"
#include "render/raster/lanes.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = SphereRaster::Setup;
using Lighting = SphereRaster::Lighting;

/// More than a sample may be from the middle of its row. [pixel]
constexpr float kRowSlack = 0.6F;

FROSTFILL_INLINE Floats stripes(Floats phase, float share, float width)
{
    // Truncating serves for floor: phases are above -4.
    const Floats fraction =
        phase - (__builtin_convertvector(__builtin_convertvector(phase + 4, Mask), Floats) - 4);
    const Floats fromMiddle = max(fraction - 0.5F, 0.5F - fraction);
    const Floats crisp =
        clamped((fromMiddle - 0.5F * (1 - share)) * (1 / std::max(width, 1e-4F)) + 0.5F);
    const float mean = std::clamp(2.5F * width - 0.75F, 0.0F, 1.0F);
    return crisp + (share - crisp) * mean;
}

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

/// What the marks of the states leave of the light.
FROSTFILL_INLINE Floats unmarked(const Setup& s, const Places& at)
{
    const Floats ring = clamped((at.rhoSquared - 0.76F) * (1 / (2 * s.pixel + 0.02F)) + 0.5F);
    const Floats hatch =
        stripes((at.across + at.above) * 1.3F + 0.25F, SphereRaster::kHatchShare, s.pixel * 1.84F);
    return 1 - s.ring * ring - s.hatch * hatch;
}

FROSTFILL_INLINE Words inBytes(Floats red, Floats green, Floats blue)
{
    return byteOf(red) | byteOf(green) << 8 | byteOf(blue) << 16 | 0xff000000U;
}

struct InClean
{
    const Setup& s;

    template <bool marked>
    FROSTFILL_INLINE Words shaded(const Normals& normals, const Places& at) const
    {
        Floats light = lightOf(dot(normals, s.up), dot(normals, s.key), dot(normals, s.fill),
                               dot(normals, s.back)) *
                       (0.64F + 0.36F * min(1.7F * at.w, 1));
        Floats gloss{};
        if constexpr (marked)
        {
            gloss = power32(max(dot(normals, s.highlight), 0)) * s.gloss;
            light *= unmarked(s, at);
        }
        return inBytes(s.tint[0] * light + s.haze[0] + gloss, s.tint[1] * light + s.haze[1] + gloss,
                       s.tint[2] * light + s.haze[2] + gloss);
    }
};

/// sphere.frag has what is behind these numbers.
struct InStudio
{
    const Setup& s;
    const Lighting& l;

    /// Multiplies by what neighbours let through of the sky and of the lamp.
    FROSTFILL_INLINE void takeLight(const Normals& normals, Floats facing, Floats& sky,
                                    Floats& lamp) const
    {
        for (std::size_t i = 0; i < l.count; ++i)
        {
            const Lighting::Occluder& o = l.occluders[i];
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

    template <bool marked>
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
        if constexpr (marked)
        {
            gloss = power32(max(dot(normals, s.highlight), 0)) * s.gloss;
            left = unmarked(s, at);
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

/// Columns of the tile in which a row may meet the outline's inside, samples included: where
/// (K D.R)^2 + (K D.A)^2 < (D.C)^2, which is quadratic in dx.
FROSTFILL_INLINE std::array<int, 2> columnsOf(const Setup& s, float aboveRow, float alongRow,
                                              const PixelRectangle& rows, float left)
{
    const float larger = 1 + kRowSlack * s.pixel;
    const float along = alongRow * larger;
    const float alongX = s.alongX * larger;
    const float a = s.acrossX * s.acrossX + s.aboveX * s.aboveX - alongX * alongX;
    const float b = aboveRow * s.aboveX - along * alongX;
    const float c = aboveRow * aboveRow - along * along;
    if (!(a > 0))
    {
        return {rows.left, rows.right}; // it reaches behind the eye
    }
    const float squared = b * b - a * c;
    if (!(squared > 0))
    {
        return {0, 0};
    }
    const float middle = s.x - left - b / a;
    const float half = std::sqrt(squared) / a;
    const float low = std::max(middle - half - 1, static_cast<float>(rows.left));
    const float high = std::min(middle + half + 1, static_cast<float>(rows.right));
    return low < high ? std::array{static_cast<int>(low), static_cast<int>(std::ceil(high))}
                      : std::array{0, 0};
}

template <int samples, bool marked, class Look>
FROSTFILL_INLINE void drawRows(const Setup& s, const Look& look, const PixelRectangle& rows,
                               const TilePart& part, SampleTile& tile)
{
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float dy = static_cast<float>(part.bottom + y) + 0.5F - s.y;
        const float aboveRow = s.aboveY * dy;
        const float alongRow = s.along + s.alongY * dy;
        const auto [from, to] =
            columnsOf(s, aboveRow, alongRow, rows, static_cast<float>(part.left));
        for (int x = from & ~(kLanes - 1); x < to; x += kLanes)
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
            const Floats isNear = q + (q * s.radiusOverDistance + s.rise) * w;
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
                seen[k] = (a * a + b * b < c * c) & (c > 0) & (isNear > before);
                seenAtAll |= seen[k];
                store(select(seen[k], isNear, before), held);
            }
            if (!any(seenAtAll))
            {
                continue;
            }
            const Floats t = 1 / (1 + s.radiusOverDistance * w);
            const Words rgba = look.template shaded<marked>(
                Normals{(s.radiusOverDistance + w) * t, across * t, above * t},
                Places{across, above, rhoSquared, w});
            for (std::size_t k = 0; k < samples; ++k)
            {
                std::uint32_t* shown = tile.colour[k].data() + at;
                store(select(seen[k], rgba, load<Words>(shown)), shown);
            }
        }
    }
}

template <int samples, bool marked>
FROSTFILL_INLINE void drawLit(const Setup& setup, const Lighting* lighting,
                              const PixelRectangle& rows, const TilePart& part, SampleTile& tile)
{
    const Setup s = setup; // so that the tile cannot be part of it
    if (lighting != nullptr)
    {
        drawRows<samples, marked>(s, InStudio{s, *lighting}, rows, part, tile);
    }
    else
    {
        drawRows<samples, marked>(s, InClean{s}, rows, part, tile);
    }
}

template <int samples>
FROSTFILL_INLINE void drawAny(const Setup& setup, const Lighting* lighting,
                              const PixelRectangle& rows, const TilePart& part, SampleTile& tile)
{
    if (setup.gloss + setup.ring + setup.hatch > 0)
    {
        drawLit<samples, true>(setup, lighting, rows, part, tile);
    }
    else
    {
        drawLit<samples, false>(setup, lighting, rows, part, tile);
    }
}

FROSTFILL_INLINE void drawSamples(int samples, const Setup& setup, const Lighting* lighting,
                                  const PixelRectangle& rows, const TilePart& part,
                                  SampleTile& tile)
{
    if (samples > 1)
    {
        drawAny<kMaxTileSamples>(setup, lighting, rows, part, tile);
    }
    else
    {
        drawAny<1>(setup, lighting, rows, part, tile);
    }
}

FROSTFILL_AVX2 void drawAvx2(int samples, const Setup& setup, const Lighting* lighting,
                             const PixelRectangle& rows, const TilePart& part, SampleTile& tile)
{
    drawSamples(samples, setup, lighting, rows, part, tile);
}

void drawPlain(int samples, const Setup& setup, const Lighting* lighting,
               const PixelRectangle& rows, const TilePart& part, SampleTile& tile)
{
    drawSamples(samples, setup, lighting, rows, part, tile);
}

} // namespace

void SphereRaster::draw(const SphereInstance& sphere, const PixelRectangle& pixels,
                        const TilePart& part, SampleTile& tile, const SphereLight* light) const
{
    const PixelRectangle rows = part.within(pixels);
    Axes axes;
    Setup setup;
    if (rows.empty() || !setUp(sphere, light != nullptr, axes, setup))
    {
        return;
    }
    Lighting lighting;
    if (light != nullptr)
    {
        setLighting(*light, axes, lighting);
    }
    (avx2_ ? drawAvx2 : drawPlain)(samples_, setup, light != nullptr ? &lighting : nullptr, rows,
                                   part, tile);
}

} // namespace frostfill
