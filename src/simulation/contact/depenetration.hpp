// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/tolerances.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

/// Moves of a sphere until it is given up.
inline constexpr int kMoves = 24;

/// What is known of a place before it is looked at.
enum class Start
{
    anywhere,
    inside ///< the object; its side need not be found out, only walls within a radius
};

/// Adds to a box the centres of all spheres, whose radius is at most 1, with a surface within
/// `distance` of p. While no sphere comes to rest in the box of all that an answer has looked at,
/// the answer stays the same, bit for bit.
inline void addSeen(Eigen::AlignedBox3d& box, const Eigen::Vector3d& p, double distance)
{
    const double reach = distance + 1 + kClearance;
    box.extend(Eigen::Vector3d(p.array() - reach));
    box.extend(Eigen::Vector3d(p.array() + reach));
}

/// Fills a grid with the running spheres, by row, where they are now.
void gather(SphereGrid& grid, const RunningSpheres& running);

/// Whether a sphere at the place would touch none of a grid's spheres.
[[nodiscard]] bool isClearOf(const SphereGrid& grid, const Eigen::Vector3d& place, double radius);

/// Moves p out of all overlaps that a sphere of `radius` there would have with the walls and with
/// spheres at rest, pushing it out of the deepest one again and again. Returns whether a clear
/// place was found within `farthest` of where p was, by so many moves.
[[nodiscard]] bool depenetrate(const World& world, Eigen::Vector3d& p, double radius,
                               double farthest, int moves = kMoves, Start start = Start::anywhere);

/// The same where one more sphere were at rest.
[[nodiscard]] bool depenetrate(const World& world, const PlacedSphere& newcomer, Eigen::Vector3d& p,
                               double radius, double farthest, int moves);

} // namespace frostfill
