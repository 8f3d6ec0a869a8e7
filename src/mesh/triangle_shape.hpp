// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace frostfill
{

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle has no area if twice its area over its squared longest edge is below this. Far below
/// what single precision can express on purpose, far above rounding in double precision.
inline constexpr double kFlatTriangle = 1e-12;

[[nodiscard]] inline std::array<Eigen::Vector3d, 3> cornersOf(const TriangleMesh& mesh,
                                                              std::size_t triangle)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

[[nodiscard]] inline bool repeatsCorner(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

[[nodiscard]] inline bool isFlat(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c)
{
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() <= kFlatTriangle * longest;
}

[[nodiscard]] inline bool isFlat(const TriangleMesh& mesh, const Triangle& t)
{
    return repeatsCorner(t) ||
           isFlat(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

[[nodiscard]] inline double areaOf(const TriangleMesh& mesh, const Triangle& t)
{
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    return 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
}

/// The corners in ascending order. Triangles with the same vertices then compare equal.
[[nodiscard]] inline Triangle sortedCorners(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

/// Gives each corner of each triangle the vertex numberOf(vertex).
template <class NumberOf>
void renumberCorners(TriangleMesh& mesh, NumberOf&& numberOf)
{
    for (Triangle& t : mesh.triangles)
    {
        for (std::uint32_t& corner : t)
        {
            corner = static_cast<std::uint32_t>(numberOf(corner));
        }
    }
}

/// Removes the triangles whose number fulfils a condition. Returns how many.
template <class IsGone>
std::size_t eraseTriangles(TriangleMesh& mesh, IsGone&& isGone)
{
    std::uint32_t number = 0;
    return std::erase_if(mesh.triangles, [&](const Triangle&) { return isGone(number++); });
}

} // namespace frostfill
