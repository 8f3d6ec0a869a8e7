// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_specks.hpp"

#include "render/raster/lanes/lanes.hpp"

#include <algorithm>
#include <bit>

namespace frostfill
{
namespace
{

using namespace lanes;

/// All samples of a pixel at once, and where they are from its middle.
using PixelFloats = float __attribute__((vector_size(4 * kMaxTileSamples)));
using PixelWords = std::uint32_t __attribute__((vector_size(4 * kMaxTileSamples)));
using PixelMask = std::int32_t __attribute__((vector_size(4 * kMaxTileSamples)));
constexpr PixelFloats kSamplesX = {kFourSamples[0].x, kFourSamples[1].x, kFourSamples[2].x,
                                   kFourSamples[3].x};
constexpr PixelFloats kSamplesY = {kFourSamples[0].y, kFourSamples[1].y, kFourSamples[2].y,
                                   kFourSamples[3].y};

/// Blends one colour over those of a pixel's samples that are `covered`, a bit each.
FROSTFILL_INLINE void putPixel(SampleTile& tile, std::size_t at, std::uint32_t covered,
                               PixelFloats depth, std::uint32_t colour)
{
    const auto& depths = tile.inverseDepth;
    auto& colours = tile.colour;
    const PixelFloats shownAt = {depths[0][at], depths[1][at], depths[2][at], depths[3][at]};
    const PixelMask seen =
        (depth > shownAt) & ((PixelMask{1, 2, 4, 8} & static_cast<std::int32_t>(covered)) != 0);
    const PixelWords shown = {colours[0][at], colours[1][at], colours[2][at], colours[3][at]};
    const PixelWords result = blended(colour & reinterpret_cast<PixelWords>(seen), shown);
    for (std::size_t k = 0; k < kMaxTileSamples; ++k)
    {
        colours[k][at] = result[k];
    }
}

FROSTFILL_INLINE void putPixel(ShellRecord& record, std::size_t at, std::uint32_t covered,
                               PixelFloats depth, std::uint32_t colour)
{
    for (std::size_t k = 0; k < kMaxTileSamples; ++k)
    {
        record.add(k, at, depth[k], (covered >> k & 1) != 0 ? colour : 0);
    }
}

/// Premultiplied, no channel beyond the last.
FROSTFILL_INLINE std::uint32_t colourAt(const ShellSpeck& speck, int x, int y)
{
    using FourInts = std::int32_t __attribute__((vector_size(16)));
    using FourShorts = std::int16_t __attribute__((vector_size(8)));
    using FourBytes = std::uint8_t __attribute__((vector_size(4)));
    const auto channels = [](const ShellSpeck::Channels& from) __attribute__((always_inline))
    {
        return __builtin_convertvector(load<FourShorts>(from.data()), FourInts);
    };
    constexpr int kHalf = 1 << (ShellSpeck::kFraction - 1);
    FourInts value = (channels(speck.colour) + channels(speck.colourAcross) * x +
                      channels(speck.colourUpwards) * y + kHalf) >>
                     ShellSpeck::kFraction;
    value = value < 0 ? FourInts{} : value;
    const int alpha = std::min(value[3], 255);
    value = value > alpha ? FourInts{} + alpha : value;
    return std::bit_cast<std::uint32_t>(__builtin_convertvector(value, FourBytes));
}

/// The samples of a speck in `own` that lie in `pixels`, a part of it.
std::uint64_t samplesIn(const PixelRectangle& own, const PixelRectangle& pixels)
{
    constexpr int kRow = ShellSpeck::kEdge * kMaxTileSamples; // bits
    static_assert(kRow * ShellSpeck::kEdge == 64);
    const auto bits = [](int from, int end) // all of a row fit an int
    { return (std::uint64_t{1} << end) - (std::uint64_t{1} << from); };
    const std::uint64_t columns = bits((pixels.left - own.left) * kMaxTileSamples,
                                       (pixels.right - own.left) * kMaxTileSamples);
    const int above = ShellSpeck::kEdge - (pixels.top - own.bottom);
    const std::uint64_t rows = ~std::uint64_t{0} << kRow * (pixels.bottom - own.bottom);
    return (columns * 0x0001000100010001U) & rows & (~std::uint64_t{0} >> kRow * above);
}

template <class Target>
FROSTFILL_INLINE void drawSamples(const ShellSpeck& speck, const PixelRectangle& own,
                                  const PixelRectangle& pixels, Target& target)
{
    constexpr std::uint64_t kOfPixel = (1U << kMaxTileSamples) - 1;
    const PixelFloats steps = speck.depthAcross * kSamplesX + speck.depthUpwards * kSamplesY;
    std::uint64_t samples = speck.covered & samplesIn(own, pixels);
    while (samples != 0)
    {
        const int pixel = std::countr_zero(samples) / kMaxTileSamples;
        const int first = pixel * kMaxTileSamples;
        const int x = pixel % ShellSpeck::kEdge;
        const int y = pixel / ShellSpeck::kEdge;
        const float depth = speck.inverseDepth + speck.depthAcross * static_cast<float>(x) +
                            speck.depthUpwards * static_cast<float>(y);
        putPixel(target, static_cast<std::size_t>((own.bottom + y) * kTileEdge + own.left + x),
                 static_cast<std::uint32_t>(samples >> first & kOfPixel), depth + steps,
                 colourAt(speck, x, y));
        samples &= ~(kOfPixel << first);
    }
}

template <class Target>
FROSTFILL_AVX2 void drawSpeckAvx2(const ShellSpeck& speck, const PixelRectangle& own,
                                  const PixelRectangle& pixels, Target& target)
{
    drawSamples(speck, own, pixels, target);
}

template <class Target>
void drawSpeckPlain(const ShellSpeck& speck, const PixelRectangle& own,
                    const PixelRectangle& pixels, Target& target)
{
    drawSamples(speck, own, pixels, target);
}

} // namespace

void drawSpeck(bool avx2, const ShellSpeck& speck, const PixelRectangle& own,
               const PixelRectangle& pixels, SampleTile& tile)
{
    (avx2 ? drawSpeckAvx2<SampleTile> : drawSpeckPlain<SampleTile>)(speck, own, pixels, tile);
}

void drawSpeck(bool avx2, const ShellSpeck& speck, const PixelRectangle& own,
               const PixelRectangle& pixels, ShellRecord& record)
{
    (avx2 ? drawSpeckAvx2<ShellRecord> : drawSpeckPlain<ShellRecord>)(speck, own, pixels, record);
}

} // namespace frostfill
