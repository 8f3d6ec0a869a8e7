// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/runner_grid.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// Finds the pairs of running spheres that touch, or may within a step. What the solvers look at
/// afterwards are only these.
class BroadPhase
{
public:
    /// `grid` may be rebuilt at each search.
    BroadPhase(RunnerGrid& grid, Threads& threads) : grid_(grid), threads_(threads) {}

    /// Fills Runner::nearby of all of them.
    void findPairs(std::span<Runner> runners);

private:
    void findAmongAll(std::span<Runner> runners);
    void findInGrid(std::span<const Runner> runners, Runner& runner) const;

    RunnerGrid& grid_;
    Threads& threads_;
    /// What a comparison needs, close together; scratch of findAmongAll.
    struct Ball
    {
        Eigen::Vector3d centre;
        double radius;
    };
    std::vector<Ball> balls_;
};

} // namespace frostfill
