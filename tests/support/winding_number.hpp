// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cmath>

namespace frostfill
{

/// [4 pi] Signed solid angle of a triangle seen from a point: at most 1/2, and finite everywhere.
inline double solidAngle(const TriangleMesh& mesh, std::size_t triangle,
                         const Eigen::Vector3d& point)
{
    const auto& t = mesh.triangles[triangle];
    const Eigen::Vector3d a = mesh.vertices[t[0]] - point;
    const Eigen::Vector3d b = mesh.vertices[t[1]] - point;
    const Eigen::Vector3d c = mesh.vertices[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return std::atan2(numerator, denominator) / 6.283185307179586;
}

/// Generalised winding number of the surface about a point: 1 inside and 0 outside a closed mesh
/// wound outwards. The sum of signed solid angles [van Oosterom & Strackee 1983].
inline double windingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point)
{
    double sum = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        sum += solidAngle(mesh, triangle, point);
    }
    return sum;
}

} // namespace frostfill
