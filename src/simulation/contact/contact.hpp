// SPDX-License-Identifier: MIT
// Room: where spheres touch spheres and triangles: the contact kernel, sphere casts, contact cones,
// neighbour lists. All contact geometry of the simulation is here.
#pragma once

#include "mesh/interior/surface.hpp"
#include "simulation/contact/tolerances.hpp"
#include "simulation/world/running_spheres.hpp"

#include <frostfill/scene.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

// The contact kernel. Every part that asks where two things touch, and what follows from it, asks
// here: normal and depth of a contact, the speed that a collision leaves, mass, support. The judge
// of a finished state (simulation/quality) has its own, so that it cannot share our mistakes.
namespace frostfill
{

/// The part of a vector that a sphere's contacts leave: its projection onto the cone of directions
/// that lead into no contact, {d : n . d >= 0 for all n}. With gravity, the acceleration that is
/// left of it; zero when the contacts carry the whole weight. With a velocity, the velocity after
/// an inelastic collision. `normals` are unit vectors from the contacts to the centre.
[[nodiscard]] Eigen::Vector3d projectToFree(const Eigen::Vector3d& vector,
                                            std::span<const Eigen::Vector3d> normals);

/// Where a sphere touches another one or a wall.
struct Contact
{
    Eigen::Vector3d normal; ///< unit vector towards the sphere's centre, into the object at a wall
    double depth = 0;       ///< penetration depth; negative for a gap [r]
};

/// Whether two points are nearer to each other than `distance`, which is not negative.
[[nodiscard]] inline bool isWithin(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                   double distance)
{
    return (a - b).squaredNorm() < distance * distance;
}

/// The contact of two spheres. `d` leads from the other centre to the sphere's, `squared` is its
/// length squared, `reach` the sum of the radii. Two spheres in the same place have the normal
/// zero: a contact that stops nothing, because every way out is as good.
[[nodiscard]] inline Contact contactOfSpheres(const Eigen::Vector3d& d, double squared,
                                              double reach)
{
    const double distance = std::sqrt(squared);
    return {distance > 0 ? Eigen::Vector3d(d / distance) : Eigen::Vector3d::Zero(),
            reach - distance};
}

/// The same where the gap is below `gap`, none where it is not.
[[nodiscard]] inline std::optional<Contact> sphereContact(const Eigen::Vector3d& d, double reach,
                                                          double gap = 0)
{
    const double limit = reach + gap;
    const double squared = d.squaredNorm();
    if (squared >= limit * limit)
    {
        return std::nullopt;
    }
    return contactOfSpheres(d, squared, reach);
}

/// A sphere that falls straight down touches another one this much above its centre, squared; not
/// positive where it passes by. `aside` leads from one centre to the other, `reach` is the sum of
/// the radii.
[[nodiscard]] inline double squaredHeightOfTouch(const Eigen::Vector3d& aside, double reach)
{
    return reach * reach - aside.x() * aside.x() - aside.z() * aside.z();
}

/// The way on which a sphere leaves a contact: its normal, or up where the two centres are one.
[[nodiscard]] inline Eigen::Vector3d separationDirection(const Contact& contact)
{
    return contact.normal.isZero(0) ? Eigen::Vector3d::UnitY() : contact.normal;
}

/// The contact of a sphere at p with a wall at the signed distance `wall`, which is not zero. The
/// normal points into the object on either side of the wall.
[[nodiscard]] inline Contact wallContact(const SignedDistance& wall, const Eigen::Vector3d& p,
                                         double radius)
{
    return {(p - wall.closest) / wall.value, radius - wall.value};
}

/// The contact of a sphere at p with the front of triangle `id`, or with either side of a two-sided
/// one, with a gap of at most `gap`.
/// Inside a plane of several triangles only the one straight below the centre counts. The edges of
/// the others come near, too, but no sphere can touch an edge that is flat.
[[nodiscard]] inline std::optional<Contact> frontContact(const Surface& surface, std::uint32_t id,
                                                         const Eigen::Vector3d& p, double radius,
                                                         double gap = 0)
{
    if (!surface.bound(id).mayBeWithin(radius + gap, p))
    {
        return std::nullopt;
    }
    const UnsignedDistance distance = unsignedDistance(surface, id, p);
    if (distance.value > radius + gap)
    {
        return std::nullopt;
    }
    const SignedDistance wall = withSide(surface, id, p, distance);
    if (wall.value <= 0)
    {
        return std::nullopt;
    }
    const Contact contact = wallContact(wall, p, radius);
    if (surface[id].isFlat(wall.feature))
    {
        const double below = contact.normal.dot(surface.bound(id).normal);
        if ((surface[id].twoSided ? std::abs(below) : below) < 1 - kBelow)
        {
            return std::nullopt;
        }
    }
    return contact;
}

/// Adds a normal unless it is there already: triangles that meet in one point give the same one.
inline void addNormal(std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& normal)
{
    const auto same = [&](const Eigen::Vector3d& n) { return n.dot(normal) > 1 - kSameNormal; };
    if (std::none_of(normals.begin(), normals.end(), same))
    {
        normals.push_back(normal);
    }
}

/// Whether contacts with these normals carry a sphere: what they leave of its weight, as a share
/// of it, is at most `share`. `down` is the unit vector of the pull.
[[nodiscard]] inline bool isCarried(const Eigen::Vector3d& down,
                                    std::span<const Eigen::Vector3d> normals, double share)
{
    return projectToFree(down, normals).norm() <= share;
}

/// What a collision leaves of the normal speed [Newton]. Slow approaches do not bounce, or nothing
/// would ever come to rest.
struct Restitution
{
    double coefficient = MotionSettings().restitution; ///< speed after over speed before, 0..1
    double bounceSpeed = 0.5; ///< approaches slower than this do not bounce [sqrt(g r)]

    /// `approach`: relative velocity along the normal, negative when the two come nearer.
    [[nodiscard]] bool bounces(double approach) const { return approach < -bounceSpeed; }

    /// By how much the relative velocity along the normal changes: the impulse of the contact over
    /// the reduced mass. [sqrt(g r)]
    [[nodiscard]] double change(double approach) const
    {
        return -(1 + (bounces(approach) ? coefficient : 0)) * approach;
    }
};

/// Mass of a sphere in units of the run: its radius cubed, as all have the same density.
[[nodiscard]] inline double massOf(double radius)
{
    return radius * radius * radius;
}

/// Kinetic and potential energy of a running sphere, for gravity downwards along y.
[[nodiscard]] inline double energyOf(const RunningSpheres& running, std::uint32_t row,
                                     double gravity)
{
    return massOf(running.radius[row]) *
           (running.velocity[row].squaredNorm() / 2 + gravity * running.position[row].y());
}

/// The same of all that run.
[[nodiscard]] inline double energyOf(const RunningSpheres& running, double gravity)
{
    double energy = 0;
    for (std::uint32_t row = 0; row < running.size(); ++row)
    {
        energy += energyOf(running, row, gravity);
    }
    return energy;
}

} // namespace frostfill
