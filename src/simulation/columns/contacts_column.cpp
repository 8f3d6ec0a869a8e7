// SPDX-License-Identifier: MIT
#include "simulation/columns/contacts_column.hpp"

#include "simulation/quality/resting_contacts.hpp"
#include "simulation/quality/tolerances.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

const Eigen::Vector3d kNowhere = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

} // namespace

double ContactsColumn::value(std::uint32_t id) const
{
    return keeps_ ? counts_[id] : restingContacts(world_, id);
}

void ContactsColumn::update()
{
    keeps_ = true;
    again_.clear();
    const std::size_t count = world_.spheres.size();
    isAgain_.assign(count, false);
    for (std::size_t id = count; id < places_.size(); ++id)
    {
        addBeside(places_[id]); // its number has gone to another sphere, or is free
    }
    places_.resize(count, kNowhere);
    counts_.resize(count, 0);
    world_.spheres.forEachChangedSince(seen_, [this](std::uint32_t id) { look(id); });
    for (const std::uint32_t id : world_.spheres.running().id.all())
    {
        look(id); // it may have the number of one that rested
    }
    std::sort(again_.begin(), again_.end());
    for (const std::uint32_t id : again_)
    {
        const std::uint32_t now = restingContacts(world_, id);
        if (std::exchange(counts_[id], now) != now)
        {
            changes_.push_back(id);
        }
    }
}

void ContactsColumn::look(std::uint32_t id)
{
    if (id >= places_.size())
    {
        return; // withdrawn since
    }
    const bool runs = world_.spheres.isRunning(id);
    const Eigen::Vector3d now = runs ? kNowhere : world_.spheres.position(id);
    const Eigen::Vector3d before = std::exchange(places_[id], now);
    if (before == now)
    {
        return;
    }
    addBeside(before);
    addBeside(now);
    addAgain(id);
}

// Each has a dozen neighbours that may ask for it: a list of all would be longer than all else.
void ContactsColumn::addAgain(std::uint32_t id)
{
    if (!isAgain_[id])
    {
        isAgain_[id] = true;
        again_.push_back(id);
    }
}

void ContactsColumn::addBeside(const Eigen::Vector3d& place)
{
    if (!place.allFinite())
    {
        return;
    }
    constexpr double kReach = 2 + kContactGap; // of the largest spheres [r]
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(place, kReach,
                        [&](std::uint32_t row)
                        {
                            const Eigen::Vector3d apart = resting[row].position() - place;
                            if (apart.squaredNorm() <= kReach * kReach)
                            {
                                addAgain(resting.id(row));
                            }
                        });
}

} // namespace frostfill
