// SPDX-License-Identifier: MIT
#include "simulation/contact/contact.hpp"

#include "simulation/contact/tolerances.hpp"

#include <Eigen/Geometry>

namespace frostfill
{
namespace
{

bool leadsIntoNone(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& direction,
                   double tolerance)
{
    for (const Eigen::Vector3d& normal : normals)
    {
        if (normal.dot(direction) < -tolerance)
        {
            return false;
        }
    }
    return true;
}

} // namespace

// The projection onto a cone in space lies in its inside, on one of its faces, on one of its edges
// or is zero: the vector, the vector without its part along one normal, its part along the line
// that two contacts leave, nothing. The first candidate that leads into no contact, with contacts
// that push and do not pull, is the projection (Karush-Kuhn-Tucker).
Eigen::Vector3d projectToFree(const Eigen::Vector3d& vector,
                              std::span<const Eigen::Vector3d> normals)
{
    if (normals.empty())
    {
        return vector;
    }
    const double tolerance = kLeadsInto * vector.norm();
    if (leadsIntoNone(normals, vector, tolerance))
    {
        return vector;
    }
    for (const Eigen::Vector3d& normal : normals)
    {
        const double into = -normal.dot(vector);
        if (into > 0)
        {
            const Eigen::Vector3d along = vector + into * normal;
            if (leadsIntoNone(normals, along, tolerance))
            {
                return along;
            }
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        for (std::size_t j = i + 1; j < normals.size(); ++j)
        {
            const double cosine = normals[i].dot(normals[j]);
            const double intoFirst = -normals[i].dot(vector);
            const double intoSecond = -normals[j].dot(vector);
            if (intoFirst - cosine * intoSecond < 0 || intoSecond - cosine * intoFirst < 0)
            {
                continue; // one of the two would have to pull
            }
            const Eigen::Vector3d line = normals[i].cross(normals[j]);
            const double squared = line.squaredNorm();
            if (squared < kParallel * kParallel)
            {
                continue;
            }
            const Eigen::Vector3d along = line * (line.dot(vector) / squared);
            if (leadsIntoNone(normals, along, tolerance))
            {
                return along;
            }
        }
    }
    return Eigen::Vector3d::Zero();
}

} // namespace frostfill
