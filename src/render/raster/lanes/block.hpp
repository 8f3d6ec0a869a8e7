// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/half_lanes.hpp"

#include <cstdint>
#include <type_traits>

namespace frostfill::lanes
{

/// Pixels that are worked out at once: kLanes of one row, or half as many each of two rows, which
/// what is no wider fills better.
template <int rows>
struct Block
{
    static constexpr int kRows = rows;
    static constexpr int kColumns = kLanes / rows;

    /// The column of each lane, from that of the first.
    static FROSTFILL_INLINE Floats across()
    {
        return rows == 1 ? iota() : Floats{0, 1, 2, 3, 0, 1, 2, 3};
    }
    /// The row of each lane, likewise.
    static FROSTFILL_INLINE Floats upwards()
    {
        return rows == 1 ? Floats{} : Floats{0, 0, 0, 0, 1, 1, 1, 1};
    }

    /// From a plane of a tile. In registers: what memory puts together stalls its next reader.
    template <class To, class From>
    static FROSTFILL_INLINE To load(const From* from)
    {
        if constexpr (rows == 1)
        {
            return lanes::load<To>(from);
        }
        else
        {
            const auto lower = lanes::load<Half<From>>(from);
            const auto upper = lanes::load<Half<From>>(from + kTileEdge);
            return __builtin_shufflevector(lower, upper, 0, 1, 2, 3, 4, 5, 6, 7);
        }
    }
    template <class From, class To>
    static FROSTFILL_INLINE void store(const From& from, To* to)
    {
        if constexpr (rows == 1)
        {
            lanes::store(from, to);
        }
        else
        {
            lanes::store(__builtin_shufflevector(from, from, 0, 1, 2, 3), to);
            lanes::store(__builtin_shufflevector(from, from, 4, 5, 6, 7), to + kTileEdge);
        }
    }

private:
    using HalfWords = std::uint32_t __attribute__((vector_size(4 * kHalf)));
    template <class Value>
    using Half = std::conditional_t<std::is_same_v<Value, float>, HalfFloats, HalfWords>;
};

} // namespace frostfill::lanes
