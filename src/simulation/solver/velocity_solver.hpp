// SPDX-License-Identifier: MIT
// Room: what running spheres do to each other: broad phase, velocity solver, position solver,
// islands. It changes velocities and positions, never states.
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace frostfill
{

/// What the position and the velocity solver of running spheres go by.
struct SolverSettings
{
    Restitution restitution;
    int sweeps = 4; ///< of the position solver at most
    /// Piles come to rest fast, as if what lies below could not give way; otherwise slowly, and
    /// more densely.
    bool stiff = true;
    double tolerance = 1e-3; ///< penetration depth at which the sweeps end early [r]
};

/// Velocities of runners that collide. Pairs that are in contact, or that would be within a step
/// (speculative contacts), lose their approach or bounce off.
class VelocitySolver
{
public:
    /// `flight` knows what is at rest and touches each, `pairs` who is near whom.
    VelocitySolver(RunningSpheres& running, FreeFlight& flight, const BroadPhase& pairs,
                   const SolverSettings& settings)
        : running_(running), flight_(flight), pairs_(pairs), settings_(settings),
          yields_(running, [](std::uint32_t, char& yields) { yields = 1; })
    {
    }

    /// `crowd`: runners that are in a pair, by row, the lowest first; `rank`: where in it each is,
    /// by row; `down`: the direction of the pull.
    void resolve(std::span<const std::uint32_t> paired, std::span<const std::uint32_t> rank,
                 const Eigen::Vector3d& down, double dt);

    /// Whether it gives way to other runners. One that nothing at rest has carried for long stops
    /// giving way, so that it comes down to something that does.
    [[nodiscard]] bool yields(std::uint32_t row) const { return yields_[row] != 0; }
    void stopYielding(std::uint32_t row) { yields_[row] = 0; }
    void letAllYield() { std::fill(yields_.all().begin(), yields_.all().end(), char{1}); }
    /// How much of what parts a and b is a's to do. Of two that do not give way, the lower does it.
    [[nodiscard]] double shareOf(std::uint32_t a, std::uint32_t b,
                                 const Eigen::Vector3d& down) const;

private:
    struct ContactPair
    {
        std::uint32_t upper, lower; ///< runners, by row
        Eigen::Vector3d normal;     ///< from the lower to the upper
        double allowed;             ///< approach that only closes the gap [sqrt(g r)]
    };

    void findContacts(std::span<const std::uint32_t> paired, std::span<const std::uint32_t> rank,
                      double dt);
    void collide(const ContactPair& contact);
    void stopOnLower();
    void stopAtRest(std::uint32_t row);

    RunningSpheres& running_;
    FreeFlight& flight_;
    const BroadPhase& pairs_;
    SolverSettings settings_;
    RunningColumn<char> yields_;
    Eigen::Vector3d down_ = {0, -1, 0};
    std::vector<ContactPair> contacts_; ///< the lowest first
};

} // namespace frostfill
