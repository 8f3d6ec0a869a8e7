// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// A bed in voxels: cubes whose middles are sampled, x fastest.
struct DistanceField
{
    std::array<std::size_t, 3> count{};
    Eigen::Vector3d origin; ///< middle of the first voxel
    double spacing = 0;     ///< edge of a voxel
    /// [unit] to the nearest sphere or wall; negative within spheres and outside the container.
    std::vector<float> distance;
    /// 0 in the free space, 1 + number of the sphere, -1 outside the container.
    std::vector<std::int32_t> label;

    [[nodiscard]] std::size_t size() const { return count[0] * count[1] * count[2]; }
};

/// Samples a bed, with radii as treated by `shrink`, in parallel; no bit depends on the threads.
/// Within a sphere the distance is that to its surface, which is the nearest unless spheres
/// overlap. Throws Error usage for more voxels than fit.
[[nodiscard]] DistanceField sampleDistances(const Bed& bed);

} // namespace frostfill
