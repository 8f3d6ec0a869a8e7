// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace frostfill
{

/// The nearest force whose tangential part is at most `friction` times its normal one.
[[nodiscard]] Eigen::Vector3d projectToCone(const Eigen::Vector3d& force,
                                            const Eigen::Vector3d& normal, double friction);

/// What a contact can do: a force, and what resists rolling, a moment over the contact's arm.
struct ContactLoad
{
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d roll = Eigen::Vector3d::Zero();
};

/// How far both go, over the normal force.
struct ConeSlopes
{
    double friction = 0;
    double rolling = 0;
};

/// The nearest load whose normal force pushes, whose tangential force is at most the friction times
/// it, and whose moment lies across the normal and is at most the rolling friction times it.
[[nodiscard]] ContactLoad projectToCone(const ContactLoad& load, const Eigen::Vector3d& normal,
                                        const ConeSlopes& slopes);

} // namespace frostfill
