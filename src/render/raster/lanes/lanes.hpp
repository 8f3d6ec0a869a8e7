// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

// Several pixels at once, in vectors of the compiler's own: as a register of AVX2 or two of any
// x86-64 processor, whichever the function is compiled for. No product is fused with a sum, so that
// both give the same bits. What is declared here has to be inlined into such a function.

#define FROSTFILL_INLINE inline __attribute__((always_inline))

#if defined(__x86_64__)
#define FROSTFILL_AVX2 __attribute__((target("avx2")))
#else
#define FROSTFILL_AVX2
#endif

namespace frostfill::lanes
{

template <class Body>
FROSTFILL_AVX2 void withAvx2(const Body& body)
{
    body();
}

template <class Body>
void withoutAvx2(const Body& body)
{
    body();
}

/// Calls body(), compiled for AVX2 where the processor has it. Like all that it calls, the body has
/// to be inlined: a lambda needs the attribute always_inline.
template <class Body>
void inLanes(const Body& body)
{
    drawsWithAvx2 ? withAvx2(body) : withoutAvx2(body);
}

using Floats = float __attribute__((vector_size(4 * kLanes)));
using Words = std::uint32_t __attribute__((vector_size(4 * kLanes)));
using Mask = std::int32_t __attribute__((vector_size(4 * kLanes))); ///< all bits, or none

FROSTFILL_INLINE Floats all(float value)
{
    return Floats{value, value, value, value, value, value, value, value};
}

template <class To, class From>
FROSTFILL_INLINE To load(const From* from)
{
    To result;
    std::memcpy(&result, from, sizeof(result));
    return result;
}

template <class From, class To>
FROSTFILL_INLINE void store(const From& from, To* to)
{
    std::memcpy(to, &from, sizeof(from));
}

FROSTFILL_INLINE Words select(Mask mask, Words a, Words b)
{
    return mask ? a : b;
}

FROSTFILL_INLINE Floats select(Mask mask, Floats a, Floats b)
{
    return mask ? a : b;
}

FROSTFILL_INLINE bool any(Mask mask)
{
    std::array<std::uint64_t, kLanes / 2> words;
    std::memcpy(words.data(), &mask, sizeof(words));
    return (words[0] | words[1] | words[2] | words[3]) != 0;
}

FROSTFILL_INLINE Floats min(Floats a, Floats b)
{
    return a < b ? a : b; // one instruction, unlike select()
}

FROSTFILL_INLINE Floats max(Floats a, Floats b)
{
    return a > b ? a : b;
}

FROSTFILL_INLINE Floats min(Floats a, float b)
{
    return min(a, all(b));
}

FROSTFILL_INLINE Floats max(Floats a, float b)
{
    return max(a, all(b));
}

FROSTFILL_INLINE Floats clamped(Floats value)
{
    return min(max(value, 0), 1);
}

FROSTFILL_INLINE Floats root(Floats value)
{
    Floats result;
    for (int i = 0; i < kLanes; ++i)
    {
        result[i] = std::sqrt(value[i]);
    }
    return result;
}

/// As GLSL has it.
FROSTFILL_INLINE Floats smoothstep(float from, float to, Floats value)
{
    const Floats t = clamped((value - from) * (1 / (to - from)));
    return t * t * (3 - 2 * t);
}

/// To the nearest number in 0..255.
FROSTFILL_INLINE Words byteOf(Floats value)
{
    return reinterpret_cast<Words>(__builtin_convertvector(min(max(value, 0), 255) + 0.5F, Mask));
}

/// Both channels of a word, or of each of several, times `share` / 255, rounded.
template <class Word>
FROSTFILL_INLINE Word scaled(Word channels, Word share)
{
    const Word product = channels * share + 0x00800080U;
    return ((product + ((product >> 8) & 0x00ff00ffU)) >> 8) & 0x00ff00ffU;
}

/// Premultiplied colours over what is below; all 0 is clear.
template <class Word>
FROSTFILL_INLINE Word blended(Word colour, Word below)
{
    const Word left = 255 - (colour >> 24);
    return (scaled(below & 0x00ff00ffU, left) + (colour & 0x00ff00ffU)) |
           (scaled((below >> 8) & 0x00ff00ffU, left) + ((colour >> 8) & 0x00ff00ffU)) << 8;
}

/// 0, 1 and so on.
FROSTFILL_INLINE Floats iota()
{
    return Floats{0, 1, 2, 3, 4, 5, 6, 7};
}

} // namespace frostfill::lanes
