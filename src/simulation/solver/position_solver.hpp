// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/solver/solver_settings.hpp"
#include "simulation/solver/velocity_solver.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// Takes running spheres out of their overlaps with each other, one after another from below
/// (Gauss-Seidel).
class PositionSolver
{
public:
    /// `grid` may be rebuilt at each step.
    PositionSolver(RunnerGrid& grid, const FreeFlight& flight, Threads& threads,
                   const SolverSettings& settings)
        : broadPhase_(grid, threads), flight_(flight), settings_(settings),
          velocitySolver_(settings)
    {
    }

    /// Separates the runners and makes their velocities agree with it.
    void resolve(std::span<Runner> runners, double dt);

    /// Takes runners that overlap apart, without giving them any speed.
    void separate(std::span<Runner> runners);
    /// The same among some of them, given by index, as if the others were not there.
    void separate(std::span<Runner> runners, std::span<const std::uint32_t> some);

private:
    void findPairs(std::span<Runner> runners);
    void orderFromBelow(std::span<Runner> runners);
    /// `giveWay`: part of its share by which one gives way to those above it; `climbFrom`:
    /// penetration depth from which one climbs the other [own radius].
    double sweep(std::span<Runner> runners, double giveWay, double climbFrom);
    [[nodiscard]] Eigen::Vector3d pushOff(std::span<const Runner> runners, const Runner& runner,
                                          double giveWay, double climbFrom, double& deepest) const;
    void payForLifts(std::span<Runner> runners) const;

    BroadPhase broadPhase_;
    const FreeFlight& flight_;
    SolverSettings settings_;
    VelocitySolver velocitySolver_;
    Eigen::Vector3d down_ = {0, -1, 0}; ///< the pull's direction in this step
    std::vector<std::uint32_t> crowd_;  ///< runners that are in a pair, by index, lowest first
};

} // namespace frostfill
