// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <numbers>

/// Where a sphere of radius 1 comes to rest; down is -y.
namespace frostfill::oracle
{

/// Above the bottom of a groove, or the tip of a cone, of this half angle [rad].
[[nodiscard]] inline double aboveTip(double halfAngle)
{
    return 1 / std::sin(halfAngle);
}

/// Above the corner of a cube that stands on it.
[[nodiscard]] inline double aboveCorner()
{
    return std::sqrt(3.0);
}

/// Three spheres in a plane that touch each other, around (0, height, 0).
[[nodiscard]] inline std::array<Eigen::Vector3d, 3> threeTouching(double height)
{
    std::array<Eigen::Vector3d, 3> places;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 3;
        const double arm = 2 / std::sqrt(3.0);
        places[k] = {arm * std::cos(angle), height, arm * std::sin(angle)};
    }
    return places;
}

/// Above the centres of three that touch each other.
[[nodiscard]] inline double aboveThree()
{
    return 2 * std::sqrt(2.0 / 3.0);
}

} // namespace frostfill::oracle
