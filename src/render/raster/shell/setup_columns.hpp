// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/lanes.hpp"
#include "render/raster/shell/shell_raster.hpp"

#include <array>
#include <cstddef>

namespace frostfill::lanes
{

FROSTFILL_INLINE void transpose(const Floats* from, std::array<Floats, kLanes>& to)
{
    std::array<Floats, kLanes> twos;
    std::array<Floats, kLanes> fours;
    for (std::size_t i = 0; i < kLanes; i += 2)
    {
        twos[i] = __builtin_shufflevector(from[i], from[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        twos[i + 1] = __builtin_shufflevector(from[i], from[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (std::size_t i = 0; i < kLanes; i += 4)
    {
        for (std::size_t k = 0; k < 2; ++k)
        {
            const Floats& a = twos[i + k];
            const Floats& b = twos[i + k + 2];
            fours[i + 2 * k] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
            fours[i + 2 * k + 1] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
        }
    }
    for (std::size_t i = 0; i < kLanes / 2; ++i)
    {
        const Floats& a = fours[i];
        const Floats& b = fours[i + 4];
        to[i] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
        to[i + 4] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

/// What is worked out of kLanes triangles in lanes: the first members of a setup, in their order.
struct SetupColumns
{
    std::array<Floats, 3> across, upwards, from, least, share, near;
    std::array<std::array<Floats, 3>, 3> normals;
    std::array<Floats, 3> light, facing, strength;
    Floats contour, pixelsOfFacing, crease, pixelsOfCrease;
    std::array<Floats, 3> creaseDistance;
    std::array<Floats, 5> rest{}; ///< to whole blocks; written over what is set afterwards
    Mask alike;                   ///< the normals at the corners
    Mask edges;                   ///< whether any line along an edge is drawn
    Mask lines;                   ///< whether any line is
};

/// Many floats at a time: one by one takes longer, and a reader of several at once has to wait.
FROSTFILL_INLINE void write(const SetupColumns& columns,
                            std::array<ShellRaster::Setup, kLanes>& setups)
{
    using Setup = ShellRaster::Setup;
    static_assert(offsetof(SetupColumns, creaseDistance) ==
                  kLanes * offsetof(Setup, creaseDistance));
    constexpr std::size_t kBytes = offsetof(SetupColumns, alike) / kLanes;
    static_assert(kBytes % sizeof(Floats) == 0 && kBytes <= offsetof(Setup, ink));
    const auto* from = reinterpret_cast<const char*>(&columns);
    for (std::size_t at = 0; at < kBytes; at += sizeof(Floats))
    {
        std::array<Floats, kLanes> block;
        std::array<Floats, kLanes> rows;
        std::memcpy(block.data(), from + kLanes * at, sizeof(block));
        transpose(block.data(), rows);
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            std::memcpy(reinterpret_cast<char*>(&setups[lane]) + at, &rows[lane], sizeof(Floats));
        }
    }
}

} // namespace frostfill::lanes
