// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/spheres.hpp"

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
    void restart(const Spheres& spheres, std::size_t runningBegin);

    /// Takes in one step; `touched` by running sphere. Returns true when the step ends a window in
    /// which all were at rest. Spheres for which `ignored(id)` holds do not count.
    template <class Ignored>
    bool observe(const Spheres& spheres, std::size_t runningBegin, const std::vector<bool>& touched,
                 Ignored&& ignored)
    {
        const double limit = tolerance_ * tolerance_;
        for (std::size_t k = 0; k < start_.size(); ++k)
        {
            const std::size_t id = runningBegin + k;
            moved_[k] = moved_[k] || (spheres.position(id) - start_[k]).squaredNorm() > limit;
            touchedInWindow_[k] = touchedInWindow_[k] || touched[k];
        }
        if (++step_ < windowSteps_)
        {
            return false;
        }
        bool atRest = true;
        for (std::size_t k = 0; k < start_.size() && atRest; ++k)
        {
            atRest = (!moved_[k] && touchedInWindow_[k]) || ignored(runningBegin + k);
        }
        restart(spheres, runningBegin);
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
