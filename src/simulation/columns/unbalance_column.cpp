// SPDX-License-Identifier: MIT
#include "simulation/columns/unbalance_column.hpp"

#include "simulation/quality/equilibrium.hpp"

#include <utility>

namespace frostfill
{

UnbalanceColumn::Moment UnbalanceColumn::now() const
{
    return {world_.spheres.changeCount(), world_.pull.uniform, world_.pull.spin};
}

double UnbalanceColumn::value(std::uint32_t id) const
{
    const std::lock_guard guard(lock_);
    if (seen_ != now())
    {
        missing_ = unbalanceAtRest(world_);
        seen_ = now();
    }
    return world_.spheres.isRunning(id) ? 0 : missing_[world_.spheres.row(id)];
}

void UnbalanceColumn::update()
{
    if (toldAt_ == now())
    {
        return;
    }
    toldAt_ = now();
    told_.resize(world_.spheres.size(), 0);
    for (std::uint32_t id = 0; id < told_.size(); ++id)
    {
        const double missing = value(id);
        if (std::exchange(told_[id], missing) != missing)
        {
            changes_.push_back(id);
        }
    }
}

} // namespace frostfill
