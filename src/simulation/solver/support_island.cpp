// SPDX-License-Identifier: MIT
#include "simulation/solver/support_island.hpp"

#include "simulation/contact/contact.hpp"

namespace frostfill
{

// Whoever is taken out may have carried others, so these are looked at again. What is at rest may
// give a runner back that has crept into it, so all have been moved before any looks where others
// are.
void SupportIsland::keep(std::span<Runner> runners, std::vector<std::uint32_t>& members)
{
    threads_.forEach(members.size(), [&](std::size_t i) { touch(runners[members[i]]); });
    threads_.forEach(members.size(),
                     [&](std::size_t i)
                     {
                         Runner& runner = runners[members[i]];
                         runner.falls = !isCarriedToo(runners, runner);
                     });
    gone_.clear();
    for (const std::uint32_t k : members)
    {
        if (runners[k].falls)
        {
            runners[k].member = false;
            gone_.push_back(k);
        }
    }
    for (std::size_t i = 0; i < gone_.size(); ++i)
    {
        for (const std::uint32_t k : runners[gone_[i]].nearby)
        {
            if (runners[k].member && !carry(runners, runners[k]))
            {
                runners[k].member = false;
                gone_.push_back(k);
            }
        }
    }
    std::erase_if(members, [&](std::uint32_t k) { return !runners[k].member; });
}

bool SupportIsland::carry(std::span<const Runner> runners, Runner& runner) const
{
    touch(runner);
    return isCarriedToo(runners, runner);
}

void SupportIsland::touch(Runner& runner) const
{
    flight_.findContacts(runner, kCarryingGap * runner.radius);
}

bool SupportIsland::isCarriedToo(std::span<const Runner> runners, Runner& runner) const
{
    const double gap = kCarryingGap * runner.radius;
    for (const std::uint32_t k : runner.nearby)
    {
        const Runner& other = runners[k];
        if (!other.member)
        {
            continue;
        }
        if (const auto contact =
                sphereContact(runner.position - other.position, runner.radius + other.radius, gap))
        {
            runner.normals.push_back(contact->normal);
        }
    }
    return isCarried(flight_.downAt(runner.position), runner.normals, kCarried);
}

} // namespace frostfill
