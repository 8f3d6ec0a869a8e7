// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace frostfill
{

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

    FrameOfRun() = default;
    FrameOfRun(const Scene& scene, const Eigen::AlignedBox3d& box, double radius);

    [[nodiscard]] Eigen::Vector3d toRun(const Eigen::Vector3d& p) const
    {
        const Eigen::Vector3d q = (p - origin) / length;
        return {q[axis[0]], q[axis[1]], q[axis[2]]};
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
        return origin + toMeshOffset(p);
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
};

/// What pulls at a sphere, as seen from the object: gravity, turned with it, and what the object's
/// own motion adds.
struct Pull
{
    Eigen::Vector3d uniform = {0, -1, 0};             ///< gravity less the object's acceleration
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();   ///< angular velocity, about the origin
    Eigen::Vector3d spinUp = Eigen::Vector3d::Zero(); ///< its change with time
    bool turns = false;                               ///< the last two are not zero

    /// Acceleration of a free sphere at p with velocity v, both in the object's frame.
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const
    {
        if (!turns)
        {
            return uniform;
        }
        return uniform - spinUp.cross(p) - 2 * spin.cross(v) - spin.cross(spin.cross(p));
    }
    /// Unit vector that a sphere at rest at p is pulled along; zero where it is all but weightless.
    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& p) const;
};

/// How the object stands and moves in the room, in the units of the run. The simulation stays in
/// the object's frame: there walls and spheres at rest do not move, and gravity changes instead.
class ObjectMotion
{
public:
    ObjectMotion(const MoveSettings& settings, const FrameOfRun& frame, double height);

    /// How long it lasts [sqrt(r/g)]; 0 when the object never moves.
    [[nodiscard]] double duration() const { return duration_; }
    /// From the object's frame to the room's, `time` after the motion has begun.
    [[nodiscard]] Eigen::Isometry3d poseAt(double time) const;
    [[nodiscard]] Pull pullAt(double time) const;

private:
    [[nodiscard]] Eigen::Vector3d spinAt(double time) const;

    double gravity_ = 1;
    double duration_ = 0;
    double tilt_ = 0;       ///< [radian] in the end
    double turn_ = 0;       ///< [radian] in the end
    double shake_ = 0;      ///< amplitude
    double circular_ = 0;   ///< frequency of shaking, times 2 pi
    double difference_ = 0; ///< step of finite differences
};

} // namespace frostfill
