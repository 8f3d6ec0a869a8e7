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

/// The friction from which a sphere stays on two or three others on a floor that touch each other:
/// the tangent of half the angle between the vertical and the line from its centre to one below it.
/// Both contacts of a lower sphere need the same tangential force, as it turns about neither, and
/// its contact with the upper one bears less.
[[nodiscard]] inline double frictionOfPyramid(int below)
{
    const double sine = below == 2 ? 0.5 : 1 / std::sqrt(3.0);
    return sine / (1 + std::sqrt(1 - sine * sine));
}

/// The friction from which three spheres stand between two walls: the middle one lies against the
/// others in lines that rise by this angle [rad], and only the walls carry them.
[[nodiscard]] inline double frictionOfArch(double rise)
{
    return 3 * std::sin(rise) / (1 + 3 * std::cos(rise));
}

/// How fast a sphere begins to sink that lies without friction on two that touch on a floor. [g]
[[nodiscard]] inline double sinkingBetweenTwo()
{
    return 1.0 / 7;
}

} // namespace frostfill::oracle
