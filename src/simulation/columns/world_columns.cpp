// SPDX-License-Identifier: MIT
#include "simulation/columns/world_columns.hpp"

#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/equilibrium.hpp"

#include <utility>

namespace frostfill
{

std::map<std::string, MakeWorldColumn>& worldColumns()
{
    const auto orientation = [](int coefficient)
    {
        return [coefficient](const World& world)
        { return std::make_unique<OrientationColumn>(world, coefficient); };
    };
    static std::map<std::string, MakeWorldColumn> makers = {
        {"qx", orientation(0)},
        {"qy", orientation(1)},
        {"qz", orientation(2)},
        {"qw", orientation(3)},
        {"contacts",
         [](const World& world) { return std::make_unique<ColumnAtRest>(world, contactsAtRest); }},
        {"unbalance",
         [](const World& world) { return std::make_unique<ColumnAtRest>(world, unbalanceAtRest); }},
    };
    return makers;
}

ColumnAtRest::Moment ColumnAtRest::now() const
{
    return {world_.spheres.changeCount(), world_.pull.uniform, world_.pull.spin};
}

double ColumnAtRest::value(std::uint32_t id) const
{
    const std::lock_guard guard(lock_);
    if (seen_ != now())
    {
        values_ = find_(world_);
        seen_ = now();
    }
    return world_.spheres.isRunning(id) ? 0 : values_[world_.spheres.row(id)];
}

void ColumnAtRest::update()
{
    if (toldAt_ == now())
    {
        return;
    }
    toldAt_ = now();
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
