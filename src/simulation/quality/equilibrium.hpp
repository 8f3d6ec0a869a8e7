// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/quality/contact_network.hpp"
#include "simulation/world/world.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace frostfill
{

/// Whether contacts carry a sphere. `pull` is the acceleration that acts on it, `normals` are unit
/// vectors from its contacts to its centre. Contacts push and never pull; what is left of the pull
/// when they push as well as they can must be no longer than `allowed`.
[[nodiscard]] bool contactsCanCarry(const Eigen::Vector3d& pull,
                                    std::span<const Eigen::Vector3d> normals, double allowed);

/// What resists that a sphere rolls on what carries it.
struct RollingSupport
{
    double friction = 0; ///< moment over normal force and reduced radius
    double radius = 1;   ///< [r] of the sphere
    /// [r] of those that carry it, in the order of their normals; other contacts are with walls.
    std::span<const double> below = {};
};

/// The same with friction: tangential forces up to `friction` times the normal ones, and no torque.
/// `allowed` is a share of the pull.
[[nodiscard]] bool frictionCanCarry(const Eigen::Vector3d& pull,
                                    std::span<const Eigen::Vector3d> normals, double friction,
                                    double allowed, const RollingSupport& rolling = {});

/// The least friction with which all but `except` bodies miss at most `unbalance` of their weight,
/// to kFrictionStep of itself or of a tenth; infinite when none up to
/// JudgeSettings::kMostFriction will do. By bisection.
[[nodiscard]] double leastFriction(const ContactNetwork& network, double unbalance,
                                   std::size_t except, Threads& threads);

/// Judges whether all spheres at rest stay so together, under the friction of the scene's judge, or
/// under none if it names none. See JointBalance for the method and its cost.
[[nodiscard]] EquilibriumReport judgeEquilibrium(const World& world);

/// What is missing on each sphere at rest [own weight], by its row there, under the same friction;
/// 0 for less than forces settle to.
[[nodiscard]] std::vector<double> unbalanceAtRest(const World& world);

/// The forces with which spheres at rest hold one another, under the same friction.
struct ContactForces
{
    struct Pair
    {
        std::uint32_t upon; ///< id
        std::uint32_t from;
        Eigen::Vector3d force; ///< [weight of a sphere of mean volume] on `upon`
    };
    std::vector<Pair> pairs;
    double missing = 0; ///< [own weight] on a sphere, at most
};
[[nodiscard]] ContactForces forcesAtRest(const World& world);

} // namespace frostfill
