// SPDX-License-Identifier: MIT
#include <simulation/gravity_cone.hpp>

#include <Eigen/Geometry>

#include <cmath>

namespace frostfill
{
namespace
{

/// A direction may lead into a contact by this much, which is rounding.
constexpr double kLeadsInto = 1e-10;
/// Two contacts whose normals' cross product is shorter than this act as one.
constexpr double kParallel = 1e-9;

bool leadsIntoNone(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& direction)
{
    for (const Eigen::Vector3d& normal : normals)
    {
        if (normal.dot(direction) < -kLeadsInto)
        {
            return false;
        }
    }
    return true;
}

} // namespace

// The projection onto a cone in space lies in its inside, on one of its faces, on one of its edges
// or is zero: gravity, gravity without its part along one normal, its part along the line that two
// contacts leave, nothing. The first candidate that leads into no contact, with contacts that push
// and do not pull, is the projection (Karush-Kuhn-Tucker).
Eigen::Vector3d projectGravity(std::span<const Eigen::Vector3d> normals)
{
    const Eigen::Vector3d down(0, -1, 0);
    if (leadsIntoNone(normals, down))
    {
        return down;
    }
    for (const Eigen::Vector3d& normal : normals)
    {
        if (normal.y() > 0)
        {
            const Eigen::Vector3d along = down + normal.y() * normal;
            if (leadsIntoNone(normals, along))
            {
                return along;
            }
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        for (std::size_t j = i + 1; j < normals.size(); ++j)
        {
            Eigen::Vector3d line = normals[i].cross(normals[j]);
            const double length = line.norm();
            if (length < kParallel)
            {
                continue;
            }
            line /= length;
            const double cosine = normals[i].dot(normals[j]);
            const bool firstPushes = normals[i].y() - cosine * normals[j].y() >= 0;
            const bool secondPushes = normals[j].y() - cosine * normals[i].y() >= 0;
            const Eigen::Vector3d along = -line.y() * line;
            if (firstPushes && secondPushes && leadsIntoNone(normals, along))
            {
                return along;
            }
        }
    }
    return Eigen::Vector3d::Zero();
}

} // namespace frostfill
