// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/voxel_layout.hpp"

#include <optional>

namespace frostfill
{

/// Looks for a way from inside a surface to the border of the grid, for a sphere of the given
/// radius. `outer` are the cubes that the centre of such a sphere can get to from the border.
/// Returns a point in a hole, the first on the shortest way out; nothing when the surface is tight.
[[nodiscard]] std::optional<Eigen::Vector3d> findLeak(const Surface& surface,
                                                      const InsideTest& inside,
                                                      const VoxelLayout& layout,
                                                      const VoxelBits& outer, double radius);

} // namespace frostfill
