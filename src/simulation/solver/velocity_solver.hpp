// SPDX-License-Identifier: MIT
// Room: what running spheres do to each other: broad phase, velocity solver, position solver,
// islands. It changes velocities and positions, never states.
#pragma once

#include "simulation/contact/runner.hpp"

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
    struct Settings
    {
        double restitution = 0.2;
        double bounceSpeed = 0.5; ///< approaches slower than this do not bounce [sqrt(g r)]
        bool stiff = true;        ///< no approach is left to those that lie on others
    };

    explicit VelocitySolver(const Settings& settings) : settings_(settings) {}

    /// `crowd`: those that may meet others, by index, the lowest first; their rank tells which.
    void resolve(std::span<Runner> runners, std::span<const std::uint32_t> crowd,
                 const Eigen::Vector3d& down, double dt);

private:
    struct Contact
    {
        std::uint32_t upper, lower; ///< runners, by index
        Eigen::Vector3d normal;     ///< from the lower to the upper
        double allowed;             ///< approach that only closes the gap [sqrt(g r)]
    };

    void findContacts(std::span<const Runner> runners, std::span<const std::uint32_t> crowd,
                      double dt);
    void collide(Runner& a, Runner& b, const Contact& contact) const;
    void stopOnLower(std::span<Runner> runners);

    Settings settings_;
    Eigen::Vector3d down_ = {0, -1, 0};
    std::vector<Contact> contacts_; ///< the lowest first
};

} // namespace frostfill
