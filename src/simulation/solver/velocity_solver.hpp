// SPDX-License-Identifier: MIT
// Room: what running spheres do to each other: broad phase, velocity solver, position solver,
// islands. It changes velocities and positions, never states.
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/crowd.hpp"

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
    double tolerance = 1e-3;         ///< penetration depth at which the sweeps end early [r]
    double pairMargin = kPairMargin; ///< see BroadPhase
};

/// Velocities of runners that collide. Pairs that are in contact, or that would be within a step
/// (speculative contacts), lose their approach or bounce off.
class VelocitySolver
{
public:
    /// `flight` knows what is at rest and touches each.
    VelocitySolver(RunningSpheres& running, FreeFlight& flight, const Crowd& crowd,
                   const SolverSettings& settings)
        : running_(running), flight_(flight), crowd_(crowd), settings_(settings),
          yields_(running, [](std::uint32_t, char& yields) { yields = 1; })
    {
    }

    /// Changes the velocities of the crowd's runners. `down`: the direction of the pull.
    void resolve(const Eigen::Vector3d& down, double dt);

    /// Whether it gives way to other runners. One that nothing at rest has carried for long stops
    /// giving way, so that it comes down to something that does.
    [[nodiscard]] bool yields(std::uint32_t row) const { return yields_[row] != 0; }
    void stopYielding(std::uint32_t row) { yields_[row] = 0; }
    void yieldAgain(std::uint32_t row) { yields_[row] = 1; }
    void letAllYield() { std::fill(yields_.all().begin(), yields_.all().end(), char{1}); }
    /// How much of what parts two of the crowd, given by slot, is a's to do. Of two that do not
    /// give way, the lower does it.
    [[nodiscard]] double shareOf(std::uint32_t a, std::uint32_t b,
                                 const Eigen::Vector3d& down) const;

private:
    struct ContactPair
    {
        std::uint32_t lower;    ///< slot
        Eigen::Vector3d normal; ///< from the lower to the upper
        double allowed;         ///< approach that only closes the gap [sqrt(g r)]
    };

    /// A member in contact with lower ones.
    struct Unit
    {
        std::uint32_t upper; ///< slot
        std::uint32_t end;   ///< of its contacts; they begin where those of the one before end
    };
    /// The lowest first.
    struct InSlab
    {
        std::vector<Unit> units;
        std::vector<ContactPair> contacts;
    };
    void findContacts(std::size_t slab, double dt);
    template <class Visit>
    void sweep(Visit&& visit) const;
    void collide(std::uint32_t upper, const ContactPair& contact);
    void stopOnLower(std::uint32_t upper, std::span<const ContactPair> contacts);
    void stopAtRest(std::uint32_t slot);

    RunningSpheres& running_;
    FreeFlight& flight_;
    const Crowd& crowd_;
    SolverSettings settings_;
    RunningColumn<char> yields_;
    Eigen::Vector3d down_ = {0, -1, 0};
    std::vector<InSlab> slabs_;
    // By slot.
    std::vector<Eigen::Vector3d> velocity_;
    std::vector<std::span<const Eigen::Vector3d>> normals_; ///< of what is at rest and touches it
};

} // namespace frostfill
