// SPDX-License-Identifier: MIT
#include "simulation/columns/world_columns.hpp"

#include "simulation/columns/contacts_column.hpp"
#include "simulation/columns/unbalance_column.hpp"

namespace frostfill
{

std::map<std::string, MakeWorldColumn>& worldColumns()
{
    static std::map<std::string, MakeWorldColumn> makers = {
        {"contacts", [](const World& world) { return std::make_unique<ContactsColumn>(world); }},
        {"unbalance", [](const World& world) { return std::make_unique<UnbalanceColumn>(world); }},
    };
    return makers;
}

} // namespace frostfill
