// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/runner_grid.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/velocity_solver.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// VelocitySolver of runners with each other, one after another from below (Gauss-Seidel).
class PositionSolver
{
public:
    struct Settings
    {
        double restitution = 0.2;
        double bounceSpeed = 0.5; ///< [sqrt(g r)]
        int sweeps = 4;
        /// Piles come to rest fast, as if what lies below could not give way; otherwise slowly, and
        /// more densely.
        bool stiff = true;
        double tolerance = 1e-3; ///< penetration depth at which the sweeps end early [r]
    };

    /// `grid` may be rebuilt at each step.
    PositionSolver(RunnerGrid& grid, const FreeFlight& flight, Threads& threads,
                   const Settings& settings)
        : grid_(grid), flight_(flight), threads_(threads), settings_(settings),
          velocitySolver_({settings.restitution, settings.bounceSpeed, settings.stiff})
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
    void findPairsOfFew(std::span<Runner> runners);
    void findNearRunners(std::span<const Runner> runners, Runner& runner) const;
    void orderFromBelow(std::span<Runner> runners);
    /// `giveWay`: part of its share by which one gives way to those above it; `climbFrom`:
    /// penetration depth from which one climbs the other [own radius].
    double sweep(std::span<Runner> runners, double giveWay, double climbFrom);
    [[nodiscard]] Eigen::Vector3d pushOff(std::span<const Runner> runners, const Runner& runner,
                                          double giveWay, double climbFrom, double& deepest) const;
    void payForLifts(std::span<Runner> runners) const;

    RunnerGrid& grid_;
    const FreeFlight& flight_;
    Threads& threads_;
    Settings settings_;
    VelocitySolver velocitySolver_;
    Eigen::Vector3d down_ = {0, -1, 0};  ///< the pull's direction in this step
    std::vector<Eigen::Vector4d> balls_; ///< centres and radii, scratch of findPairsOfFew
    std::vector<std::uint32_t> crowd_;   ///< runners that meet others, by index, lowest first
};

} // namespace frostfill
