// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/solver/crowd.hpp"
#include "simulation/solver/velocity_solver.hpp"

#include <functional>
#include <span>
#include <vector>

namespace frostfill
{

/// Takes running spheres out of their overlaps with each other, one after another from below
/// (Gauss-Seidel).
class PositionSolver
{
public:
    PositionSolver(RunningSpheres& running, FreeFlight& flight, Threads& threads,
                   const SolverSettings& settings)
        : running_(running), pairs_(running, threads, settings.pairMargin), flight_(flight),
          settings_(settings), crowd_(running, pairs_, threads),
          velocitySolver_(running, flight, crowd_, settings)
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
    /// How members are taken apart.
    struct Sweeps
    {
        int most;
        double tolerance; ///< penetration depth at which they end early [r]
        double liftDepth; ///< penetration depth from which one climbs the other [own radius]
        /// Whether in a sweep, counted from 0, one gives way to those above it by its share.
        std::function<bool(int sweep)> isMutual;
    };
    /// Returns the deepest penetration that the last sweep has found. [r]
    double sweep(const Sweeps& sweeps);
    double sweepOnce(double yieldShare, double liftDepth);
    double sweepSlab(const Crowd::Slab& slab, double yieldShare, double liftDepth);
    /// `deepest` starts at that of the members before.
    [[nodiscard]] Eigen::Vector3d pushOff(std::uint32_t slot, double yieldShare, double liftDepth,
                                          double& deepest) const;
    void removeLiftEnergy(std::uint32_t slot);

    RunningSpheres& running_;
    BroadPhase pairs_;
    FreeFlight& flight_;
    SolverSettings settings_;
    Crowd crowd_;
    VelocitySolver velocitySolver_;
    Eigen::Vector3d down_ = {0, -1, 0}; ///< the pull's direction in this step
    // By slot, in the step in hand.
    struct Flown
    {
        Eigen::Vector3d position; ///< after this step's flight
        Eigen::Vector3d velocity; ///< at its end
    };
    std::vector<Flown> flown_;
    std::vector<double> deepest_; ///< by slab: penetration that its last sweep has found
};

} // namespace frostfill
