// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/solver/velocity_solver.hpp"

#include <optional>
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
    PositionSolver(RunningSpheres& running, RunnerGrid& grid, FreeFlight& flight, Threads& threads,
                   const SolverSettings& settings)
        : running_(running), pairs_(running, grid, threads), flight_(flight), settings_(settings),
          velocitySolver_(running, flight, pairs_, settings)
    {
    }

    /// Separates the runners and makes their velocities agree with it.
    void resolve(double dt);

    /// Takes runners that overlap apart, without giving them any speed.
    void separate();
    /// The same among some of them, given by row, as if the others were not there.
    void separate(std::span<const std::uint32_t> some);

    [[nodiscard]] const BroadPhase& pairs() const { return pairs_; }
    [[nodiscard]] VelocitySolver& velocities() { return velocitySolver_; }

private:
    static constexpr std::uint32_t kNotInCrowd = 0xffffffff;

    void findPairs();
    void sortByHeight();
    /// `yieldShare`: part of its share by which one gives way to those above it; `liftDepth`:
    /// penetration depth from which one climbs the other [own radius].
    double sweep(double yieldShare, double liftDepth);
    /// `deepest` starts at that of the rows before. Returns no push for what touches no other.
    [[nodiscard]] std::optional<Eigen::Vector3d> pushOff(std::uint32_t row, double yieldShare,
                                                         double liftDepth, double& deepest) const;
    void removeLiftEnergy();

    RunningSpheres& running_;
    BroadPhase pairs_;
    FreeFlight& flight_;
    SolverSettings settings_;
    VelocitySolver velocitySolver_;
    Eigen::Vector3d down_ = {0, -1, 0}; ///< the pull's direction in this step
    std::vector<std::uint32_t> paired_; ///< runners that are in a pair, by row, lowest first
    // By row, of those in the crowd, in the step in hand.
    std::vector<double> height_;                  ///< against the pull [r]
    std::vector<std::uint32_t> rank_;             ///< in the crowd
    std::vector<Eigen::Vector3d> flown_;          ///< position after this step's flight
    std::vector<Eigen::Vector3d> velocityBefore_; ///< at the end of that flight
    /// Whether it touched none of those near it, none of which has been pushed since: it need not
    /// be looked at.
    std::vector<char> clear_;
};

} // namespace frostfill
