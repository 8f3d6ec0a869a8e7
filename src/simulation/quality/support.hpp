// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <span>

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

} // namespace frostfill
