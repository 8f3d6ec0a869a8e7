// SPDX-License-Identifier: MIT
#include <simulation/support.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kParallel = 1e-12; // below this determinant rays span no face of their own
constexpr double kInside = -1e-9;   // a coefficient that counts as not negative

double squaredMiss(const Eigen::Vector3d& carried)
{
    return (Eigen::Vector3d::UnitY() - carried).squaredNorm();
}

// Least squares of up on two rays; counts only when both push.
double missOfPair(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const double ab = a.dot(b);
    const double determinant = 1 - ab * ab;
    if (determinant < kParallel)
    {
        return 1;
    }
    const double alpha = (a.y() - ab * b.y()) / determinant;
    const double beta = (b.y() - ab * a.y()) / determinant;
    return alpha >= 0 && beta >= 0 ? squaredMiss(alpha * a + beta * b) : 1;
}

// Three rays carry everything when up lies between them.
bool carriedByThree(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    const double determinant = a.dot(b.cross(c));
    if (std::abs(determinant) < kParallel)
    {
        return false;
    }
    const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    return up.dot(b.cross(c)) / determinant >= kInside &&
           a.dot(up.cross(c)) / determinant >= kInside &&
           a.dot(b.cross(up)) / determinant >= kInside;
}

} // namespace

double unsupportedWeight(std::span<const Eigen::Vector3d> normals)
{
    double best = 1;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        const Eigen::Vector3d& a = normals[i];
        if (a.y() > 0)
        {
            best = std::min(best, squaredMiss(a.y() * a));
        }
        for (std::size_t j = i + 1; j < normals.size(); ++j)
        {
            best = std::min(best, missOfPair(a, normals[j]));
            for (std::size_t k = j + 1; k < normals.size(); ++k)
            {
                if (carriedByThree(a, normals[j], normals[k]))
                {
                    return 0;
                }
            }
        }
    }
    return std::sqrt(best);
}

} // namespace frostfill
