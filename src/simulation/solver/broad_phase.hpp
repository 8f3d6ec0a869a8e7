// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/solver/tolerances.hpp"
#include "simulation/world/running_spheres.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// Finds the pairs of running spheres that touch, or may within a step. What the solvers look at
/// afterwards are only these.
class BroadPhase
{
public:
    /// `margin`: gap up to which two are a pair. [r]
    BroadPhase(RunningSpheres& running, Threads& threads, double margin = kPairMargin)
        : running_(running), threads_(threads), margin_(margin), nearby_(running)
    {
    }

    void findPairs();
    /// The same as if each runner had this radius, by row [r].
    void findPairs(std::span<const double> radii);
    /// Runners that the last search has found near this one, by row, ascending. One that has begun
    /// to run since has those of the sphere that had its row before.
    [[nodiscard]] const std::vector<std::uint32_t>& nearby(std::uint32_t row) const
    {
        return nearby_[row];
    }
    [[nodiscard]] bool isPaired(std::uint32_t row) const { return !nearby_[row].empty(); }

private:
    [[nodiscard]] bool mayTouch(const Eigen::Vector3d& a, double radiusOfA,
                                const Eigen::Vector3d& b, double radiusOfB) const;
    void findAmongAll(std::span<const double> radii);

    RunningSpheres& running_;
    Threads& threads_;
    double margin_;
    RunningColumn<std::vector<std::uint32_t>> nearby_;
};

} // namespace frostfill
