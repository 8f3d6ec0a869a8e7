// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/solver/crowd.hpp"
#include "simulation/solver/velocity_solver.hpp"

#include <functional>
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
    PositionSolver(RunningSpheres& running, FreeFlight& flight, Threads& threads,
                   const SolverSettings& settings)
        : running_(running), pairs_(running, threads), flight_(flight), settings_(settings),
          crowd_(running, pairs_, threads), velocitySolver_(running, flight, crowd_, settings)
    {
        if (settings.usualRadius < 1)
        {
            pairs_.expectSizes(settings.usualRadius, settings.dt);
        }
    }

    /// Separates the runners and makes their velocities agree with it. Calls observe(row) for each
    /// runner once it is where it stays, on any thread.
    using Observe = std::function<void(std::uint32_t row)>;
    void resolve(
        double dt, const Observe& observe = [](std::uint32_t) {});

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
    void resolveCrowd(double dt, const Observe& observe);
    /// Returns the deepest penetration that the last sweep has found. [r]
    double sweep(const Sweeps& sweeps);
    double sweepOnce(double yieldShare, double liftDepth);
    double sweepSlab(const Crowd::Slab& slab, double yieldShare, double liftDepth);
    /// `deepest` starts at that of the members before. Returns no push for who touches no other.
    [[nodiscard]] std::optional<Eigen::Vector3d> pushOff(std::uint32_t slot, double yieldShare,
                                                         double liftDepth, double& deepest) const;
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
    /// Whether it touched none of those near it, none of which has been pushed since: it need not
    /// be looked at.
    std::vector<char> clear_;
    std::vector<double> deepest_; ///< by slab: penetration that its last sweep has found
};

} // namespace frostfill
