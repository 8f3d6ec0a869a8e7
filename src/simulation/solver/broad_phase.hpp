// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/runner_grid.hpp"

#include <vector>

namespace frostfill
{

/// Finds the pairs of running spheres that touch, or may within a step. What the solvers look at
/// afterwards are only these.
class BroadPhase
{
public:
    /// `grid` may be rebuilt at each search.
    BroadPhase(RunningSpheres& running, RunnerGrid& grid, Threads& threads)
        : running_(running), grid_(grid), threads_(threads), nearby_(running)
    {
    }

    void findPairs();
    /// Runners that the last search has found near this one, by row, ascending. One that has begun
    /// to run since has those of whoever had its row before.
    [[nodiscard]] const std::vector<std::uint32_t>& nearby(std::uint32_t row) const
    {
        return nearby_[row];
    }

private:
    void findAmongAll();
    void findInGrid(std::uint32_t row);

    RunningSpheres& running_;
    RunnerGrid& grid_;
    Threads& threads_;
    RunningColumn<std::vector<std::uint32_t>> nearby_;
};

} // namespace frostfill
