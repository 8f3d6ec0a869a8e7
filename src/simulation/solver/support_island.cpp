// SPDX-License-Identifier: MIT
#include "simulation/solver/support_island.hpp"

#include "simulation/contact/contact.hpp"

namespace frostfill
{

// A sphere that is taken out may have supported others, so these are looked at again. What is at
// rest may give a runner back that has crept into it, so all have been moved before any looks where
// others are.
void SupportIsland::keep(std::vector<std::uint32_t>& members)
{
    member_.assign(running_.size(), 0);
    falls_.resize(running_.size());
    for (const std::uint32_t row : members)
    {
        member_[row] = 1;
    }
    threads_.forEach(members.size(), [&](std::size_t i) { touch(members[i]); });
    threads_.forEach(members.size(),
                     [&](std::size_t i) { falls_[members[i]] = isCarriedToo(members[i]) ? 0 : 1; });
    gone_.clear();
    for (const std::uint32_t row : members)
    {
        if (falls_[row] != 0)
        {
            dismiss(row);
            gone_.push_back(row);
        }
    }
    for (std::size_t i = 0; i < gone_.size(); ++i)
    {
        for (const std::uint32_t row : pairs_.nearby(gone_[i]))
        {
            if (member_[row] != 0 && !carry(row))
            {
                dismiss(row);
                gone_.push_back(row);
            }
        }
    }
    std::erase_if(members, [&](std::uint32_t row) { return member_[row] == 0; });
}

bool SupportIsland::carry(std::uint32_t row)
{
    touch(row);
    return isCarriedToo(row);
}

void SupportIsland::touch(std::uint32_t row)
{
    flight_.findContacts(row, kCarryingGap * running_.radius[row]);
}

bool SupportIsland::isCarriedToo(std::uint32_t row)
{
    const Eigen::Vector3d position = running_.position[row];
    const double radius = running_.radius[row];
    for (const std::uint32_t other : pairs_.nearby(row))
    {
        if (member_[other] == 0)
        {
            continue;
        }
        if (const auto contact =
                sphereContact(position - running_.position[other], radius + running_.radius[other],
                              kCarryingGap * radius))
        {
            flight_.normals(row).push_back(contact->normal);
        }
    }
    return isCarried(flight_.downAt(position), flight_.normals(row), kCarried);
}

} // namespace frostfill
