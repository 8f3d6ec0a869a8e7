// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/inside_test.hpp"

#include <frostfill/mesh.hpp>

#include <cstdint>
#include <limits>

namespace frostfill
{

/// The object around a packing, in the unit and the frame of its mesh.
class Container
{
public:
    /// `mesh` is closed and wound outwards. `length` is that of what will be looked at, such as a
    /// diameter.
    Container(const TriangleMesh& mesh, double length);

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const { return inside_.contains(p); }
    /// Infinite where none is within `limit`.
    [[nodiscard]] double
    distanceToWall(const Eigen::Vector3d& p,
                   double limit = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] Eigen::Vector3d nearestWallPoint(const Eigen::Vector3d& p) const;
    /// Pieces of wall within `reach` of p; see wallPieces().
    [[nodiscard]] std::uint32_t wallsWithin(const Eigen::Vector3d& p, double reach) const;

    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return surface_.box(); }
    [[nodiscard]] const MeshReport& report() const { return report_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return surface_.mesh(); }

    Container(const Container&) = delete;
    Container& operator=(const Container&) = delete;

private:
    MeshReport report_;
    Surface surface_;
    TriangleGrid grid_;
    InsideTest inside_;
};

} // namespace frostfill
