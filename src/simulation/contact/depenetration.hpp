// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/tolerances.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

/// Moves p out of all overlaps that a sphere of `radius` there would have with the walls and with
/// spheres at rest, pushing it out of the deepest one again and again. Returns whether a clear
/// place was found within `farthest` of where p was, by so many moves.
[[nodiscard]] bool depenetrate(const World& world, Eigen::Vector3d& p, double radius,
                               double farthest, int moves = 24);

/// The same where one more sphere were at rest.
[[nodiscard]] bool depenetrate(const World& world, const PlacedSphere& newcomer, Eigen::Vector3d& p,
                               double radius, double farthest, int moves);

} // namespace frostfill
