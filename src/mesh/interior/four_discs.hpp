// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>

namespace frostfill
{

/// Four planes, and discs in them, as TriangleBound has them for one triangle, tested at once in
/// single precision. All lengths are in a frame in which the mesh is as large as 1.
struct FourDiscs
{
    static constexpr unsigned kFour = 4;
    using Four = float __attribute__((vector_size(4 * kFour))); // registers of all processors
    /// By which a squared distance may be wrong, twofold. [1]
    static constexpr double kRounding = 0x1p-20;

    /// A place, four times over, and by how much rounding may be wrong there.
    struct Point
    {
        std::array<Four, 3> at;
        float rounding;
    };
    /// A straight way: its middle, and what it goes to either side of it.
    struct Way
    {
        Point middle;
        std::array<Four, 3> half;
        float reach; ///< around the way
        float ball;  ///< around its middle
    };

    /// A bit for each disc of that thickness, to either side, set where some of it may be within a
    /// distance of a point.
    [[nodiscard]] unsigned mayBeWithin(const Four& thickness, const Point& point,
                                       float distance) const;
    /// The same, within the reach of a way.
    [[nodiscard]] unsigned mayBeOnWay(const Four& thickness, const Way& way) const;

    using Mask = decltype(Four{} < Four{});
    /// A bit for each that holds.
    [[nodiscard]] static unsigned bitsOf(const Mask& mask)
    {
#if defined(__SSE__)
        return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Four>(mask)));
#else
        unsigned bits = 0;
        for (unsigned k = 0; k < kFour; ++k)
        {
            bits |= mask[k] != 0 ? 1U << k : 0U;
        }
        return bits;
#endif
    }
    [[nodiscard]] static Four fourTimes(float value)
    {
        return Four{} + value;
    }

    std::array<Four, 3> normal;
    Four offset;
    std::array<Four, 3> centre;
    Four radius;
};

// The test of TriangleBound, where what is subtracted is made smaller and what is added larger by
// more than rounding. The distance has been grown by what the place may be wrong.
inline unsigned FourDiscs::mayBeWithin(const Four& thickness, const Point& point,
                                       float distance) const
{
    constexpr auto kLess = static_cast<float>(1 - kRounding);
    constexpr Four kNone = {};
    Four toPlane = -offset;
    Four toCentre{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        toPlane += normal[axis] * point.at[axis];
        const Four apart = centre[axis] - point.at[axis];
        toCentre += apart * apart;
    }
    const Four behind = -toPlane;
    const Four height = toPlane > behind ? toPlane : behind;
    const Four above = height - (thickness + point.rounding);
    const Four least = above > kNone ? above : kNone;
    const Four most = height + point.rounding;
    // In a plane through the nearest of it, the ball around the point is a disc of this radius.
    const Four cut = distance * distance - least * least;
    const Four rest = toCentre * kLess - (most * most + radius * radius + cut);
    const Mask within =
        (cut >= kNone) & ((rest <= kNone) | (rest * rest <= 4.0F * radius * radius * cut));
    return bitsOf(within);
}

// All of the way is at least as far from a plane as its middle, less what it goes towards it.
inline unsigned FourDiscs::mayBeOnWay(const Four& thickness, const Way& way) const
{
    Four toPlane = -offset;
    Four across{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        toPlane += normal[axis] * way.middle.at[axis];
        across += normal[axis] * way.half[axis];
    }
    const Four behind = -toPlane;
    const Four back = -across;
    const Four height = toPlane > behind ? toPlane : behind;
    const Mask within = height <= (across > back ? across : back) +
                                      (thickness + (way.reach + 2 * way.middle.rounding));
    return bitsOf(within) & mayBeWithin(thickness, way.middle, way.ball);
}

} // namespace frostfill
