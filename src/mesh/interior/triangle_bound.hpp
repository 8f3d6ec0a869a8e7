// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace frostfill
{

/// The plane of a triangle and a disc in it around the triangle, in one cache line, for quick
/// rejection.
struct alignas(64) TriangleBound
{
    Eigen::Vector3d normal; ///< of the plane, into the object
    double offset = 0;      ///< normal . x for points x of the plane
    Eigen::Vector3d centre;
    double radius = 0;

    /// False only if every point of the triangle is farther than `distance` from p. What a sphere
    /// that rests on a fine mesh has around it is within its radius of the planes of many triangles
    /// and of the balls around them, but of the discs of few.
    [[nodiscard]] bool mayBeWithin(double distance, const Eigen::Vector3d& p) const
    {
        const double height = toPlane(p);
        const double centreSquared = toCentreSquared(p);
        if (height > distance || !ballIsWithin(distance, centreSquared))
        {
            return false;
        }
        // Of the disc in which the plane cuts the ball around p; without a root of its radius.
        const double cutSquared = distance * distance * (1 + kDiscRounding) - height * height;
        const double rest = centreSquared - height * height - radius * radius - cutSquared;
        return rest <= 0 || rest * rest <= 4 * radius * radius * cutSquared;
    }
    [[nodiscard]] double toPlane(const Eigen::Vector3d& p) const
    {
        return std::abs(normal.dot(p) - offset);
    }
    [[nodiscard]] double toCentreSquared(const Eigen::Vector3d& p) const
    {
        return (p - centre).squaredNorm();
    }
    /// Of a point by its distance to the centre.
    [[nodiscard]] bool ballIsWithin(double distance, double centreSquared) const
    {
        const double reach = radius + distance;
        return centreSquared <= reach * reach;
    }

private:
    /// [1] of a squared distance, far above its rounding. Larger: more triangles are tested.
    static constexpr double kDiscRounding = 1e-8;
};

[[nodiscard]] TriangleBound boundOf(const std::array<Eigen::Vector3d, 3>& corner);

} // namespace frostfill
