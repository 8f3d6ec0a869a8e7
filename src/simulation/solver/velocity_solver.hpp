// SPDX-License-Identifier: MIT
// Room: what running spheres do to each other: broad phase, velocity solver, position solver,
// islands. It changes velocities and positions, never states.
#pragma once

#include "simulation/contact/runner.hpp"
#include "simulation/solver/solver_settings.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// How much of what parts a and b is a's to do. One that nothing at rest has carried for long stops
/// giving way, so that it comes down to something that does; of two such, the lower.
[[nodiscard]] double shareOf(const Runner& a, const Runner& b, const Eigen::Vector3d& down);

/// Velocities of runners that collide. Pairs that are in contact, or that would be within a step
/// (speculative contacts), lose their approach or bounce off.
class VelocitySolver
{
public:
    explicit VelocitySolver(const SolverSettings& settings) : settings_(settings) {}

    /// `crowd`: runners that are in a pair, by index, the lowest first, as their rank says.
    void resolve(std::span<Runner> runners, std::span<const std::uint32_t> crowd,
                 const Eigen::Vector3d& down, double dt);

private:
    struct ContactPair
    {
        std::uint32_t upper, lower; ///< runners, by index
        Eigen::Vector3d normal;     ///< from the lower to the upper
        double allowed;             ///< approach that only closes the gap [sqrt(g r)]
    };

    void findContacts(std::span<const Runner> runners, std::span<const std::uint32_t> crowd,
                      double dt);
    void collide(Runner& a, Runner& b, const ContactPair& contact) const;
    void stopOnLower(std::span<Runner> runners);

    SolverSettings settings_;
    Eigen::Vector3d down_ = {0, -1, 0};
    std::vector<ContactPair> contacts_; ///< the lowest first
};

} // namespace frostfill
