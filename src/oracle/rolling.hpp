// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

/// A full sphere on a plane, with friction: units of gravity and of the sphere's radius and mass.
/// Any textbook of mechanics.
namespace frostfill::oracle
{

/// Acceleration down a slope [rad] of a sphere that rolls without slipping. `rolling` is the moment
/// that resists it, over normal force and radius.
[[nodiscard]] inline double rollingDown(double slope, double rolling = 0)
{
    return 5.0 / 7 * (std::sin(slope) - rolling * std::cos(slope));
}

/// The least friction with which it rolls and does not slip.
[[nodiscard]] inline double frictionToRoll(double slope)
{
    return 2.0 / 7 * std::tan(slope);
}

/// Acceleration of one that slips, and its angular one.
[[nodiscard]] inline double slidingDown(double slope, double friction)
{
    return std::sin(slope) - friction * std::cos(slope);
}
[[nodiscard]] inline double spinOfSliding(double slope, double friction)
{
    return 2.5 * friction * std::cos(slope);
}

/// Speed at which one that was pushed along a level floor without spin ends up rolling.
[[nodiscard]] inline double rollingAfterSliding(double speed)
{
    return 5.0 / 7 * speed;
}

/// What a bounce takes away from the speed along the floor if the sphere slips all the while
/// [Walton 1993]: `approach` is the normal speed before.
[[nodiscard]] inline double slowedByBounce(double approach, double restitution, double friction)
{
    return friction * (1 + restitution) * approach;
}

/// The friction of all surfaces with which a sphere stays on three that touch each other on a
/// floor: contacts push along the line between them, which makes half of its angle with the
/// vertical.
[[nodiscard]] inline double frictionOfPyramid()
{
    return std::sqrt(3.0) - std::numbers::sqrt2;
}

} // namespace frostfill::oracle
