// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace frostfill
{

/// On which side of a line or a plane a point lies: exact for all coordinates that are 0 or between
/// 1e-80 and 1e80 in magnitude, as are their differences. Beyond, products underflow or overflow.

/// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they lie on a line.
[[nodiscard]] int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                           const Eigen::Vector2d& c);

/// +1 if d is on the side from which a, b, c turn counter-clockwise, -1 if it is on the other side,
/// 0 if the four points lie in a plane.
[[nodiscard]] int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// Two triangles of a surface, with the corners that they share in front and in the same order.
/// Both have an area. Corners with equal coordinates need not be shared: two sheets may touch
/// there.
struct TrianglePair
{
    using Corners = std::array<Eigen::Vector3d, 3>;

    Corners a;
    Corners b;
    int shared = 0; ///< 0 to 3 corners
};

/// Whether the corners do not lie on a line. Exact.
[[nodiscard]] bool hasArea(const TrianglePair::Corners& triangle);

/// Whether the triangles have a point in common that belongs to no shared corner or edge. To touch
/// is to cross. Exact, see orient3d.
[[nodiscard]] bool trianglesCross(const TrianglePair& pair);

} // namespace frostfill
