// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <vector>

namespace frostfill
{

/// A part of an object that the run has moved nearer to the others.
struct MovedPart
{
    Eigen::AlignedBox3d box; ///< [r] where it would be
    Eigen::Vector3d shift;   ///< [r] from there to where it is
    double end = 0;          ///< [r] the next part's x are larger
};

/// The simulation's own coordinates: the box's centre is the origin, y is up, lengths are counted
/// in the largest sphere's radius and times in sqrt(radius / gravity). Every tolerance is then a
/// pure number. Axes are permuted, never rotated, so that no bit is lost.
struct FrameOfRun
{
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< mesh coordinates
    std::array<int, 3> axis = {0, 1, 2};              ///< mesh axis that becomes x, y, z
    double length = 1;                                ///< [mesh unit] of one radius
    double time = 1;                                  ///< [s] of one unit
    double gravity = 1;                               ///< downwards; 1, or 0 without gravity
    /// In a row along x, ascending: parts that lie so far apart that a grid over all of them would
    /// hold next to nothing. Empty: nothing is moved.
    std::vector<MovedPart> moved;

    FrameOfRun() = default;
    FrameOfRun(const Scene& scene, const Eigen::AlignedBox3d& box, double radius);
    /// With the parts of a mesh, that has this box, moved together if they lie far apart, unless
    /// the object moves.
    FrameOfRun(const Scene& scene, const TriangleMesh& mesh, const Eigen::AlignedBox3d& box,
               double radius);

    [[nodiscard]] Eigen::Vector3d toRun(const Eigen::Vector3d& p) const
    {
        const Eigen::Vector3d q = (p - origin) / length;
        const Eigen::Vector3d r(q[axis[0]], q[axis[1]], q[axis[2]]);
        return moved.empty() ? r : together(r);
    }
    /// A vector in mesh coordinates.
    [[nodiscard]] Eigen::Vector3d toMeshOffset(const Eigen::Vector3d& p) const
    {
        Eigen::Vector3d q;
        for (int k = 0; k < 3; ++k)
        {
            q[axis[k]] = p[k] * length;
        }
        return q;
    }
    [[nodiscard]] Eigen::Vector3d toMesh(const Eigen::Vector3d& p) const
    {
        return origin + toMeshOffset(apart(p));
    }
    /// Where a point would be if no part had been moved.
    [[nodiscard]] Eigen::Vector3d apart(const Eigen::Vector3d& p) const
    {
        return moved.empty() ? p : Eigen::Vector3d(p - partAt(p).shift);
    }
    [[nodiscard]] Eigen::Matrix3d toMeshRotation(const Eigen::Matrix3d& rotation) const
    {
        Eigen::Matrix3d q;
        for (int row = 0; row < 3; ++row)
        {
            for (int column = 0; column < 3; ++column)
            {
                q(axis[row], axis[column]) = rotation(row, column);
            }
        }
        return q;
    }
    [[nodiscard]] TriangleMesh toRun(const TriangleMesh& mesh) const;

private:
    [[nodiscard]] const MovedPart& partAt(const Eigen::Vector3d& p) const;
    /// The other way round: a point of the nearest part, by where they would be.
    [[nodiscard]] Eigen::Vector3d together(const Eigen::Vector3d& p) const;
};

} // namespace frostfill
