// SPDX-License-Identifier: MIT
// Room: closed forms and reference packings, which studies measure by and tests judge by. It knows
// nothing of the simulation.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <numbers>

/// How one sphere moves, or two. Lengths in r, times in sqrt(r/g), masses in that of a sphere of
/// radius r; down is -y.
namespace frostfill::oracle
{

/// The way fallen from rest.
[[nodiscard]] inline double fall(double time)
{
    return time * time / 2;
}

/// By how much less explicit Euler has fallen after steps of dt, and semi-implicit Euler more.
[[nodiscard]] inline double eulerLag(double time, double dt)
{
    return time * dt / 2;
}

/// The energy over mass that explicit Euler gains in every step of a free fall.
[[nodiscard]] inline double eulerGain(double dt)
{
    return dt * dt / 2;
}

/// Where a sphere is that started at the origin.
[[nodiscard]] inline Eigen::Vector3d thrown(const Eigen::Vector3d& velocity, double time)
{
    return {velocity.x() * time, velocity.y() * time - fall(time), velocity.z() * time};
}

/// The height to which a sphere bounces that has fallen from `height`.
[[nodiscard]] inline double bounceApex(double height, double restitution)
{
    return restitution * restitution * height;
}

/// The time until it lies still, infinitely many bounces later.
[[nodiscard]] inline double bouncesEnd(double height, double restitution)
{
    return std::sqrt(2 * height) * (1 + restitution) / (1 - restitution);
}

/// The time that it bounces below a height that it has just reached.
[[nodiscard]] inline double bouncesBelow(double height, double restitution)
{
    return std::sqrt(8 * height) / (1 - restitution);
}

/// Speeds along the line of centres after a collision.
struct Speeds
{
    double first = 0;
    double second = 0;
};
[[nodiscard]] inline Speeds collide(double firstMass, double firstSpeed, double secondMass,
                                    double secondSpeed, double restitution)
{
    const double mass = firstMass + secondMass;
    const double common = (firstMass * firstSpeed + secondMass * secondSpeed) / mass;
    const double parting = restitution * (firstSpeed - secondSpeed);
    return {common - parting * secondMass / mass, common + parting * firstMass / mass};
}

/// The way slid from rest down a plane at `angle` [rad] to the horizontal, without friction.
[[nodiscard]] inline double slide(double angle, double time)
{
    return std::sin(angle) * time * time / 2;
}

/// The period of a sphere that slides in a round bowl, to the fourth power of the amplitude [rad].
[[nodiscard]] inline double bowlPeriod(double bowlRadius, double amplitude)
{
    const double squared = amplitude * amplitude;
    return 2 * std::numbers::pi * std::sqrt(bowlRadius - 1) *
           (1 + squared / 16 + 11 * squared * squared / 3072);
}

} // namespace frostfill::oracle
