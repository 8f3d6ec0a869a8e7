// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <Eigen/Core>

#include <limits>
#include <span>

namespace frostfill
{

/// What resists that spheres roll while they fill the object. Without `resistance` nothing does,
/// and they slide.
struct RollingLaw
{
    double friction = 0;   ///< Coulomb's
    double resistance = 0; ///< moment over normal force and reduced radius

    /// Of the scene: none where sizes differ; the smaller friction of spheres and walls, because
    /// contacts are not told apart.
    [[nodiscard]] static RollingLaw of(const Scene& scene);
    [[nodiscard]] bool any() const { return resistance > 0; }
};

/// How a sphere goes on that touches what is at rest.
struct Rolling
{
    Eigen::Vector3d pull; ///< its acceleration, and what presses it against its contacts
    bool stands = false;  ///< it is held where it is
    double time = std::numeric_limits<double>::infinity(); ///< until it stands still
};

/// A full sphere that rolls along its contacts, as one does on a plane. With a pull along them p
/// and a normal force n it accelerates by 5/7 (p - c n), c being the resistance; the torque of the
/// friction that this takes, 2/7 p + 5/7 c n, is the one that spins it. Where that is more than the
/// friction times n it slips, by p - friction n. It stands where p is at most c n, and the friction
/// times n. Its spin is not kept, so what it takes on the way down is not given back: on the way
/// up p slows it whole, and no energy is ever gained.
///
/// `lever`: the reduced radius over its own, at most 1.
[[nodiscard]] Rolling rollAlong(const RollingLaw& law, const Eigen::Vector3d& velocity,
                                const Eigen::Vector3d& pull,
                                std::span<const Eigen::Vector3d> normals, double lever);

/// Whether contacts hold it that stands.
[[nodiscard]] inline bool holdsStanding(const RollingLaw& law, const Eigen::Vector3d& pull,
                                        std::span<const Eigen::Vector3d> normals, double lever)
{
    return law.any() && !normals.empty() &&
           rollAlong(law, Eigen::Vector3d::Zero(), pull, normals, lever).stands;
}

} // namespace frostfill
