// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace frostfill
{

/// Tells whether a cube holds a place for the centre of a sphere, one that is clear of the walls
/// and of all spheres at rest together: OpenCubes alone closes a cube only when a single obstacle
/// excludes all of it. The cube is cut into 64 parts. A part that no obstacle excludes counts as
/// clear.
class ClearSearch
{
public:
    static constexpr int kSide = 4; ///< parts of a cube side by side

    /// The grids live as long as this object. `probe`: radius of the smallest sphere [r].
    ClearSearch(const SphereGrid& resting, const TriangleGrid& triangles, double probe)
        : resting_(resting), triangles_(triangles), probe_(probe)
    {
    }

    /// The places that a cube may hold.
    enum class Place
    {
        none,
        elsewhere, ///< in parts that are not wanted
        wanted
    };
    /// `none` only when no point of the cube is clear of the walls and of the first `rows` spheres
    /// at rest; otherwise whether isWanted(middle) holds for one of the parts that may be clear.
    [[nodiscard]] Place find(const Eigen::Vector3d& middle, double edge, std::uint32_t rows,
                             const std::function<bool(const Eigen::Vector3d&)>& isWanted) const;
    [[nodiscard]] bool mayHold(const Eigen::Vector3d& middle, double edge, std::uint32_t rows) const
    {
        return find(middle, edge, rows, [](const Eigen::Vector3d&) { return true; }) != Place::none;
    }
    /// Whether none of the first `rows` spheres at rest excludes a part by now that was clear.
    [[nodiscard]] bool isStillClear(const Eigen::Vector3d& part, double edge,
                                    std::uint32_t rows) const;
    /// How far a point of a part is from its middle at most.
    [[nodiscard]] static double reachOfPart(double edge) { return kHalfDiagonal * edge / kSide; }

private:
    [[nodiscard]] std::optional<Eigen::Vector3d> wallNear(const Eigen::Vector3d& p,
                                                          double distance) const;

    const SphereGrid& resting_;
    const TriangleGrid& triangles_;
    double probe_;
};

} // namespace frostfill
