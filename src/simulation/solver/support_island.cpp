// SPDX-License-Identifier: MIT
#include "simulation/solver/support_island.hpp"

#include "simulation/contact/contact_cone.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kContactGap = 0.005; // below which a contact carries [own radius]
constexpr double kUncarried = 0.05;   // share of the weight that may remain

} // namespace

// Whoever is taken out may have carried others, so these are looked at again.
void SupportIsland::keep(std::span<Runner> runners, std::vector<std::uint32_t>& members)
{
    threads_.forEach(members.size(),
                     [&](std::size_t i)
                     {
                         Runner& runner = runners[members[i]];
                         runner.falls = !carry(runners, runner);
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
    flight_.findContacts(runner, kContactGap * runner.radius);
    for (const std::uint32_t k : runner.nearby)
    {
        const Eigen::Vector3d d = runner.position - runners[k].position;
        const double contact = runner.radius * (1 + kContactGap) + runners[k].radius;
        const double squared = d.squaredNorm();
        if (runners[k].member && squared < contact * contact && squared > 0)
        {
            runner.normals.push_back(d / std::sqrt(squared));
        }
    }
    return projectToFree(flight_.downAt(runner.position), runner.normals).norm() < kUncarried;
}

} // namespace frostfill
