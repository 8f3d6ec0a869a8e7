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

/// The same with friction: tangential forces up to `friction` times the normal ones, and no torque.
/// `allowed` is a share of the pull.
[[nodiscard]] bool frictionCanCarry(const Eigen::Vector3d& pull,
                                    std::span<const Eigen::Vector3d> normals, double friction,
                                    double allowed);

} // namespace frostfill
