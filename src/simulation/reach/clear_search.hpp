// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <cstdint>

namespace frostfill
{

/// Tells whether a cube holds a place for the centre of a sphere, one that is clear of the walls
/// and of all spheres at rest together: OpenCubes alone closes a cube only when a single obstacle
/// excludes all of it. The cube is cut into 64 parts. A part that no obstacle excludes counts as
/// clear.
class ClearSearch
{
public:
    /// The searches live as long as this. `probe`: radius of the smallest sphere [r].
    ClearSearch(const SphereGrid& resting, const TriangleGrid& triangles, double probe)
        : resting_(resting), triangles_(triangles), probe_(probe)
    {
    }

    /// False only when no point of the cube is clear of the walls and of the first `rows` spheres
    /// at rest.
    [[nodiscard]] bool mayHold(const Eigen::Vector3d& middle, double edge,
                               std::uint32_t rows) const;

private:
    const SphereGrid& resting_;
    const TriangleGrid& triangles_;
    double probe_;
};

} // namespace frostfill
