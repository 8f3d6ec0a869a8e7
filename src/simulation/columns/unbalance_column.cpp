// SPDX-License-Identifier: MIT
#include "simulation/columns/unbalance_column.hpp"

#include "simulation/quality/equilibrium.hpp"

#include <utility>

namespace frostfill
{

double UnbalanceColumn::value(std::uint32_t id) const
{
    const std::lock_guard guard(lock_);
    if (seen_ != world_.spheres.changeCount())
    {
        missing_ = unbalanceAtRest(world_);
        seen_ = world_.spheres.changeCount();
    }
    return world_.spheres.isRunning(id) ? 0 : missing_[world_.spheres.row(id)];
}

void UnbalanceColumn::update()
{
    if (toldAt_ == world_.spheres.changeCount())
    {
        return;
    }
    toldAt_ = world_.spheres.changeCount();
    told_.resize(world_.spheres.size(), 0);
    for (std::uint32_t id = 0; id < told_.size(); ++id)
    {
        const double now = value(id);
        if (std::exchange(told_[id], now) != now)
        {
            changes_.push_back(id);
        }
    }
}

} // namespace frostfill
