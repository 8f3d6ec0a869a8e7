// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/half_lanes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill::lanes
{

/// The corners of kHalf triangles.
template <class Vertex>
class Corners
{
public:
    /// triangleIn(lane) is its number.
    template <class TriangleIn>
    FROSTFILL_INLINE Corners(const std::vector<Vertex>& vertices,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles,
                             TriangleIn triangleIn)
    {
        for (std::size_t lane = 0; lane < kHalf; ++lane)
        {
            const std::array<std::uint32_t, 3>& triangle = triangles[triangleIn(lane)];
            for (std::size_t corner = 0; corner < 3; ++corner)
            {
                vertices_[corner][lane] = &vertices[triangle[corner]];
            }
        }
    }

    template <class ValueOf>
    [[nodiscard]] FROSTFILL_INLINE Doubles gather(std::size_t corner, ValueOf valueOf) const
    {
        const auto& own = vertices_[corner];
        return Doubles{valueOf(*own[0]), valueOf(*own[1]), valueOf(*own[2]), valueOf(*own[3])};
    }
    /// valueOf(vertex, lane) in single precision.
    template <class ValueOf>
    [[nodiscard]] FROSTFILL_INLINE HalfFloats gatherSingle(std::size_t corner,
                                                           ValueOf valueOf) const
    {
        const auto& own = vertices_[corner];
        return HalfFloats{valueOf(*own[0], 0), valueOf(*own[1], 1), valueOf(*own[2], 2),
                          valueOf(*own[3], 3)};
    }
    [[nodiscard]] FROSTFILL_INLINE std::array<DoubleVectors, 3> places() const
    {
        std::array<DoubleVectors, 3> result;
        for (std::size_t i = 0; i < 3; ++i)
        {
            result[i] = {gather(i, [](const Vertex& v) { return v.corner.x; }),
                         gather(i, [](const Vertex& v) { return v.corner.y; }),
                         gather(i, [](const Vertex& v) { return v.corner.z; })};
        }
        return result;
    }

private:
    std::array<std::array<const Vertex*, kHalf>, 3> vertices_;
};

} // namespace frostfill::lanes
