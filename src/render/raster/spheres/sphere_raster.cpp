// SPDX-License-Identifier: MIT
#include "render/raster/spheres/sphere_raster.hpp"

#include "render/raster/spheres/sphere_looks.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = SphereRaster::Setup;
using Drawn = SphereRaster::Drawn;

/// More than a sample may be from the middle of its row. [pixel]
constexpr float kRowSlack = 0.6F;

/// Columns of the tile in which a row may meet the outline's inside, samples included: where
/// (K D.R)^2 + (K D.A)^2 < (D.C)^2, which is quadratic in dx.
FROSTFILL_INLINE std::array<int, 2> columnsOf(const Setup& s, float aboveRow, float alongRow,
                                              const PixelRectangle& rows, float left)
{
    const float larger = 1 + kRowSlack * s.look.pixel;
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

template <int samples, Marks marks, class Look>
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
                seen[k] = (a * a + b * b < c * c) & (c > s.leastAlong) & (c < s.mostAlong) &
                          (isNear > before);
                seenAtAll |= seen[k];
                store(select(seen[k], isNear, before), held);
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

template <int samples>
FROSTFILL_INLINE void drawAny(const Drawn& drawn, const PixelRectangle& rows, const TilePart& part,
                              SampleTile& tile)
{
    withLook(
        drawn, [&](const Setup& s, const auto& look, auto marks) __attribute__((always_inline)) {
            drawRows<samples, decltype(marks)::value>(s, look, rows, part, tile);
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
        drawCutSphere(samples_, drawn, rows, part, tile);
        return;
    }
    inLanes([&]() __attribute__((always_inline)) {
        samples_ > 1 ? drawAny<kMaxTileSamples>(drawn, rows, part, tile)
                     : drawAny<1>(drawn, rows, part, tile);
    });
}

} // namespace frostfill
