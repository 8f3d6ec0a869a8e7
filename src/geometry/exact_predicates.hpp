// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

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

} // namespace frostfill
