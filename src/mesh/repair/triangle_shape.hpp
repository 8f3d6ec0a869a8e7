// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <algorithm>

namespace frostfill
{

using Triangle = std::array<std::uint32_t, 3>;

/// Twice the area over the longest edge squared, below which a triangle counts as without area.
/// Far below what single precision can express on purpose, far above rounding in double.
inline constexpr double kFlat = 1e-12;

[[nodiscard]] inline bool repeatsCorner(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

[[nodiscard]] inline bool isFlat(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c)
{
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() <= kFlat * longest;
}

[[nodiscard]] inline bool isFlat(const TriangleMesh& mesh, const Triangle& t)
{
    return repeatsCorner(t) ||
           isFlat(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

/// The corners in ascending order, so that triangles of the same vertices compare equal.
[[nodiscard]] inline Triangle sortedCorners(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

} // namespace frostfill
