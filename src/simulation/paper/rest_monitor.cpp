// SPDX-License-Identifier: MIT
#include "simulation/paper/rest_monitor.hpp"

namespace frostfill
{

void RestMonitor::restart(const Spheres& spheres, std::size_t runningBegin)
{
    step_ = 0;
    start_.clear();
    for (std::size_t id = runningBegin; id < spheres.size(); ++id)
    {
        start_.push_back(spheres.position(id));
    }
    moved_.assign(start_.size(), false);
    touchedInWindow_.assign(start_.size(), false);
}

} // namespace frostfill
