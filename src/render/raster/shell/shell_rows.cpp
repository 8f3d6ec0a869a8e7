// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_rows.hpp"

#include "render/raster/lanes/block.hpp"
#include "render/raster/shell/shell_cut.hpp"
#include "render/raster/shell/shell_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = ShellRaster::Setup;
using Frame = ShellRows;

/// Columns of the row, in the tile, at which any sample may be inside; not yet in whole lanes.
FROSTFILL_INLINE std::array<int, 2> columnsOf(const Setup& s,
                                              const std::array<float, 3>& overAcross, float left,
                                              float y, int first, int end)
{
    auto low = static_cast<float>(first);
    auto high = static_cast<float>(end);
    for (std::size_t i = 0; i < 3; ++i)
    {
        // A sample is at most 0.4 pixels from the middle; the distances have a slope of 1.
        const float atLeft = s.across[i] * (left + 0.5F) + s.upwards[i] * y + s.from[i] + 0.6F;
        if (s.across[i] > 1e-6F)
        {
            low = std::max(low, -atLeft * overAcross[i]);
        }
        else if (s.across[i] < -1e-6F)
        {
            high = std::min(high, -atLeft * overAcross[i] + 1);
        }
        else if (atLeft < 0)
        {
            high = low;
        }
    }
    return low < high ? std::array{static_cast<int>(low), static_cast<int>(std::ceil(high))}
                      : std::array{0, 0};
}

/// Blends what is before the samples of a tile.
template <class In>
FROSTFILL_INLINE Mask isBefore(const SampleTile& tile, std::size_t plane, std::size_t at,
                               Floats inverseDepth)
{
    return inverseDepth > In::template load<Floats>(tile.inverseDepth[plane].data() + at);
}

template <class In>
FROSTFILL_INLINE void put(SampleTile& tile, std::size_t plane, std::size_t at, Floats /*depth*/,
                          Words colour)
{
    std::uint32_t* shown = tile.colour[plane].data() + at;
    In::store(blended(colour, In::template load<Words>(shown)), shown);
}

/// Takes down all.
template <class In>
FROSTFILL_INLINE Mask isBefore(const ShellRecord& /*record*/, std::size_t /*plane*/,
                               std::size_t /*at*/, Floats inverseDepth)
{
    return inverseDepth > all(kNothing);
}

template <class In>
FROSTFILL_INLINE void put(ShellRecord& record, std::size_t plane, std::size_t at,
                          Floats inverseDepth, Words colour)
{
    static_assert(In::kRows == 1);
    std::array<float, kLanes> depths;
    std::array<std::uint32_t, kLanes> colours;
    store(inverseDepth, depths.data());
    store(colour, colours.data());
    record.add(plane, at, depths, colours);
}

/// What there is on a triangle.
enum class Detail
{
    film,
    lines,
    cut, ///< lines too
};

/// Draws a triangle block by block.
template <class In, int samples, Detail detail, class Target>
struct Painter
{
    const Setup s; // a copy, so that the target cannot be part of it
    const Frame f;
    Target& target;
    std::array<std::array<float, samples>, 3> edgeAt;
    std::array<float, samples> nearAt;
    float nearX = 0;
    float nearY = 0;

    FROSTFILL_INLINE Painter(const Setup& setup, const Frame& frame, Target& to)
        : s(setup), f(frame), target(to)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            nearX += s.near[i] * s.across[i];
            nearY += s.near[i] * s.upwards[i];
        }
        for (std::size_t k = 0; k < samples; ++k)
        {
            const SampleOffset at = samples > 1 ? kFourSamples[k] : SampleOffset{};
            nearAt[k] = nearX * at.x + nearY * at.y;
            for (std::size_t i = 0; i < 3; ++i)
            {
                edgeAt[i][k] = s.across[i] * at.x + s.upwards[i] * at.y;
            }
        }
    }

    /// Of the pixels around (x, y), which lie in the tile from `at` on, those in `drawn`.
    FROSTFILL_INLINE void draw(Floats x, Floats y, std::size_t at, Mask drawn)
    {
        const Floats d0 = s.across[0] * x + (s.upwards[0] * y + s.from[0]);
        const Floats d1 = s.across[1] * x + (s.upwards[1] * y + s.from[1]);
        const Floats d2 = s.across[2] * x + (s.upwards[2] * y + s.from[2]);
        const Floats isNear = s.near[0] * d0 + s.near[1] * d1 + s.near[2] * d2;
        std::array<Words, samples> seen;
        Mask seenAtAll{};
        for (std::size_t k = 0; k < samples; ++k)
        {
            const Mask is = drawn & (d0 + edgeAt[0][k] > s.least[0]) &
                            (d1 + edgeAt[1][k] > s.least[1]) & (d2 + edgeAt[2][k] > s.least[2]) &
                            isBefore<In>(target, k, at, isNear + nearAt[k]);
            seen[k] = reinterpret_cast<Words>(is);
            seenAtAll |= is;
        }
        if (!any(seenAtAll))
        {
            return;
        }
        const auto [surface, line] = surfaceAndLine<detail != Detail::film>(s, f, x, y, d0, d1, d2);
        Film film{surface.share, {}};
        if constexpr (detail == Detail::cut)
        {
            const Floats away = pixelsFromCut(f.cut, x, y, isNear, nearX, nearY);
            const Floats left = leftOfCut(away);
            film = lineInFilm(f.print, surface.share, max(line, lineOfCut(away, f.lineWidth)));
            film.film *= left;
            film.line *= left;
        }
        else if constexpr (detail == Detail::lines)
        {
            film = lineInFilm(f.print, surface.share, line);
        }
        const Words alpha = byteOf(255 * (film.film + film.line));
        const Floats limit = __builtin_convertvector(reinterpret_cast<Mask>(alpha), Floats);
        const Floats lit = film.film * surface.light;
        const auto channel = [&](float base, float ink) __attribute__((always_inline))
        {
            return byteOf(min(base * lit + ink * film.line, limit));
        };
        const Words colour = channel(s.base.r, s.ink.r) | channel(s.base.g, s.ink.g) << 8 |
                             channel(s.base.b, s.ink.b) << 16 | alpha << 24;
        for (std::size_t k = 0; k < samples; ++k)
        {
            put<In>(target, k, at, isNear + nearAt[k], colour & seen[k]); // clear if not seen
        }
    }
};

/// Row by row, lanes that begin at multiples of kLanes.
template <int samples, Detail detail, class Target>
FROSTFILL_INLINE void drawRows(const Setup& setup, const Frame& frame, const PixelRectangle& pixels,
                               const TilePart& part, Target& target)
{
    using Row = Block<1>;
    Painter<Row, samples, detail, Target> painter(setup, frame, target);
    const PixelRectangle rows = inWholeLanes(pixels);
    const bool narrow = rows.width() <= kLanes; // to look for the columns takes longer
    std::array<float, 3> overAcross;
    for (std::size_t i = 0; i < 3; ++i)
    {
        overAcross[i] = narrow ? 0 : 1 / setup.across[i];
    }
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float yAt = static_cast<float>(part.bottom + y) + 0.5F;
        const auto [from, to] =
            narrow ? std::array{rows.left, rows.right}
                   : columnsOf(painter.s, overAcross, static_cast<float>(part.left), yAt, rows.left,
                               rows.right);
        for (int x = from & ~(kLanes - 1); x < to; x += kLanes)
        {
            const int pixel = y * kTileEdge + x;
            painter.draw(static_cast<float>(part.left + x) + 0.5F + Row::across(), all(yAt),
                         static_cast<std::size_t>(pixel), ~Mask{});
        }
    }
}

/// What is at most as wide as two rows of a block.
template <int samples, Detail detail>
FROSTFILL_INLINE void drawFew(const Setup& setup, const Frame& frame, const PixelRectangle& pixels,
                              const TilePart& part, SampleTile& tile)
{
    using Two = Block<2>;
    Painter<Two, samples, detail, SampleTile> painter(setup, frame, tile);
    const int x = std::min(pixels.left, kTileEdge - Two::kColumns);
    const Floats columns = static_cast<float>(x) + Two::across();
    const Mask inColumns =
        (columns >= static_cast<float>(pixels.left)) & (columns < static_cast<float>(pixels.right));
    for (int bottom = pixels.bottom; bottom < pixels.top; bottom += Two::kRows)
    {
        const int y = std::min(bottom, kTileEdge - Two::kRows);
        const Floats rows = static_cast<float>(y) + Two::upwards();
        const Mask inRows =
            (rows >= static_cast<float>(bottom)) & (rows < static_cast<float>(pixels.top));
        const int pixel = y * kTileEdge + x;
        painter.draw(static_cast<float>(part.left) + 0.5F + columns,
                     static_cast<float>(part.bottom) + 0.5F + rows, static_cast<std::size_t>(pixel),
                     inColumns & inRows);
    }
}

template <int samples, Detail detail, class Target>
FROSTFILL_INLINE void drawPart(const Setup& setup, const Frame& frame, const PixelRectangle& pixels,
                               const TilePart& part, Target& target)
{
    if constexpr (std::is_same_v<Target, SampleTile>)
    {
        if (pixels.width() <= Block<2>::kColumns)
        {
            drawFew<samples, detail>(setup, frame, pixels, part, target);
            return;
        }
    }
    drawRows<samples, detail>(setup, frame, pixels, part, target);
}

template <int samples, class Target>
FROSTFILL_INLINE void drawDetail(const Setup& setup, const Frame& frame,
                                 const PixelRectangle& pixels, const TilePart& part, Target& target)
{
    if (setup.cut)
    {
        drawPart<samples, Detail::cut>(setup, frame, pixels, part, target);
    }
    else if (setup.lines)
    {
        drawPart<samples, Detail::lines>(setup, frame, pixels, part, target);
    }
    else
    {
        drawPart<samples, Detail::film>(setup, frame, pixels, part, target);
    }
}

template <class Target>
FROSTFILL_INLINE void drawAny(int samples, const Setup& setup, const Frame& frame,
                              const PixelRectangle& pixels, const TilePart& part, Target& target)
{
    samples > 1 ? drawDetail<kMaxTileSamples>(setup, frame, pixels, part, target)
                : drawDetail<1>(setup, frame, pixels, part, target);
}

template <class Target>
FROSTFILL_AVX2 void drawAvx2(int samples, const Setup& setup, const Frame& frame,
                             const PixelRectangle& pixels, const TilePart& part, Target& target)
{
    drawAny(samples, setup, frame, pixels, part, target);
}

template <class Target>
void drawPlain(int samples, const Setup& setup, const Frame& frame, const PixelRectangle& pixels,
               const TilePart& part, Target& target)
{
    drawAny(samples, setup, frame, pixels, part, target);
}

} // namespace

void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, SampleTile& tile)
{
    (avx2 ? drawAvx2<SampleTile> : drawPlain<SampleTile>)(samples, setup, frame, pixels, part,
                                                          tile);
}

void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, ShellRecord& record)
{
    (avx2 ? drawAvx2<ShellRecord> : drawPlain<ShellRecord>)(samples, setup, frame, pixels, part,
                                                            record);
}

} // namespace frostfill
