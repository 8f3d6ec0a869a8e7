// SPDX-License-Identifier: MIT
#include "study/figures/pair_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

/// All spheres of a group are in one state, with the paper's method.
struct Group
{
    SphereState state = SphereState::running;
    std::size_t spheres = 0;
};

std::vector<Group> groupsOf(const Snapshot& snapshot)
{
    std::vector<Group> groups;
    for (std::size_t id = 0; id < snapshot.states.size(); ++id)
    {
        groups.resize(std::max<std::size_t>(groups.size(), snapshot.groups[id] + 1));
        groups[snapshot.groups[id]].state = snapshot.states[id];
        ++groups[snapshot.groups[id]].spheres;
    }
    return groups;
}

const char* kindOf(const Group& a, const Group& b)
{
    if (a.state == SphereState::discarded || b.state == SphereState::discarded)
    {
        return "discarded";
    }
    if (a.state == SphereState::running && b.state == SphereState::running)
    {
        return "running";
    }
    return a.state == b.state ? "none" : "frozen";
}

} // namespace

Table pairTable(const Snapshot& snapshot)
{
    Table table;
    table.headings = {"i", "j", "kind", "tests"};
    const std::vector<Group> groups = groupsOf(snapshot);
    for (std::size_t j = 0; j < groups.size(); ++j)
    {
        for (std::size_t i = 0; i <= j; ++i)
        {
            const std::string kind = kindOf(groups[i], groups[j]);
            std::size_t tests = 0;
            if (kind == "running" || kind == "frozen")
            {
                tests = i == j ? groups[i].spheres * (groups[i].spheres - 1) / 2
                               : groups[i].spheres * groups[j].spheres;
            }
            table.rows.push_back({fmt::format("{}", i + 1), fmt::format("{}", j + 1), kind,
                                  fmt::format("{}", tests)});
        }
    }
    return table;
}

} // namespace frostfill
