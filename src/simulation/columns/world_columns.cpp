// SPDX-License-Identifier: MIT
#include "simulation/columns/world_columns.hpp"

#include "simulation/columns/contacts_column.hpp"
#include "simulation/columns/orientation_column.hpp"
#include "simulation/columns/unbalance_column.hpp"

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
        {"contacts", [](const World& world) { return std::make_unique<ContactsColumn>(world); }},
        {"unbalance", [](const World& world) { return std::make_unique<UnbalanceColumn>(world); }},
    };
    return makers;
}

} // namespace frostfill
