// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/running_spheres.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Tells when all running spheres have come to rest: over a whole window of steps each has touched
/// something and none has been farther than a tolerance from where it was at the window's start. A
/// speed alone would call a sphere at the top of its bounce at rest.
class RestMonitor
{
public:
    /// `windowSteps` >= 1; `tolerance` is a distance [r].
    RestMonitor(std::uint32_t windowSteps, double tolerance)
        : windowSteps_(windowSteps), tolerance_(tolerance)
    {
    }

    /// Starts a new window.
    void restart(const RunningSpheres& running)
    {
        step_ = 0;
        start_.assign(running.position.all().begin(), running.position.all().end());
        moved_.assign(start_.size(), false);
        touchedInWindow_.assign(start_.size(), false);
    }

    /// Takes in one step; `touched` by row. Returns true when the step ends a window in which all
    /// were at rest. Spheres for which `ignored(row)` holds do not count.
    template <class Ignored>
    bool observe(const RunningSpheres& running, const std::vector<bool>& touched, Ignored&& ignored)
    {
        const double limit = tolerance_ * tolerance_;
        for (std::uint32_t k = 0; k < start_.size(); ++k)
        {
            moved_[k] = moved_[k] || (running.position[k] - start_[k]).squaredNorm() > limit;
            touchedInWindow_[k] = touchedInWindow_[k] || touched[k];
        }
        if (++step_ < windowSteps_)
        {
            return false;
        }
        bool atRest = true;
        for (std::uint32_t k = 0; k < start_.size() && atRest; ++k)
        {
            atRest = (!moved_[k] && touchedInWindow_[k]) || ignored(k);
        }
        restart(running);
        return atRest;
    }

private:
    std::uint32_t windowSteps_;
    double tolerance_;
    std::uint32_t step_ = 0;
    std::vector<Eigen::Vector3d> start_;
    std::vector<bool> moved_;
    std::vector<bool> touchedInWindow_;
};

} // namespace frostfill
