// SPDX-License-Identifier: MIT
#pragma once

#include "study/table.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/snapshot.hpp>

#include <Eigen/Geometry>

#include <array>

namespace frostfill
{

/// A plane with axes of its own, in mesh coordinates.
struct SectionPlane
{
    Eigen::Vector3d origin;
    Eigen::Vector3d across; ///< unit vectors, orthogonal
    Eigen::Vector3d upward;

    [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p) const
    {
        return {across.dot(p - origin), upward.dot(p - origin)};
    }
    [[nodiscard]] double distance(const Eigen::Vector3d& p) const
    {
        return across.cross(upward).dot(p - origin);
    }
};

/// Circles in which the plane cuts spheres: `state,x,y,radius`, lengths in `unit`.
[[nodiscard]] Table circlesOf(const Snapshot& snapshot, const SectionPlane& plane, double unit);

/// Lines in which the plane cuts triangles: `state,polygon,x,y,dx,dy`.
[[nodiscard]] Table tracesOf(const TriangleMesh& mesh, const std::vector<PolygonState>& states,
                             const SectionPlane& plane, double unit);

} // namespace frostfill
