// SPDX-License-Identifier: MIT
#include "simulation/freezing/room_maker.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

void RoomMaker::findOverlapped(std::uint32_t index, const PlacedSphere& resting)
{
    overlapped_.clear();
    runners_.grid().forEachNear(resting.place, resting.radius + 1,
                                [&](std::uint32_t k, const Eigen::Vector3d& p, double radiusThere)
                                {
                                    const double contact = radiusThere + resting.radius;
                                    if (k != index && !runners_.isAsleep(k) &&
                                        (p - resting.place).squaredNorm() < contact * contact)
                                    {
                                        overlapped_.push_back(k);
                                    }
                                });
    std::sort(overlapped_.begin(), overlapped_.end());
}

bool RoomMaker::makeRoom(std::uint32_t index, const PlacedSphere& resting, double farthest)
{
    findOverlapped(index, resting);
    moved_.clear();
    for (const std::uint32_t k : overlapped_)
    {
        const Runner& runner = runners_[k];
        moved_.push_back(runner.position);
        if (!depenetrate(world_, resting, moved_.back(), runner.radius, farthest * runner.radius,
                         kMovesOutOfWedge))
        {
            return false;
        }
    }
    for (std::size_t i = 0; i < overlapped_.size(); ++i)
    {
        runners_.put(overlapped_[i], moved_[i]);
    }
    return true;
}

void RoomMaker::evict()
{
    const ReleaseQuery query = {.suits = [this](const Eigen::Vector3d& place, double radius)
                                { return runners_.isClear(place, radius); }};
    for (const std::uint32_t k : overlapped_)
    {
        Runner& other = runners_[k];
        Eigen::Vector3d clear = other.position;
        if (depenetrate(world_, clear, other.radius, kFarRoom * other.radius))
        {
            runners_.put(k, clear);
        }
        else if (const auto elsewhere = followers_.release->place(other.radius, query))
        {
            runners_.restart(k, *elsewhere);
        }
        else
        {
            runners_.putToSleep(k); // not to be looked at any more
            withdraw(other);
        }
    }
}

void RoomMaker::withdraw(Runner& runner)
{
    const std::uint32_t id = std::exchange(runner.id, Runner::kNobody);
    const std::uint32_t renumbered = world_.withdraw(id);
    if (followers_.discard)
    {
        followers_.discard->renumber(renumbered, id);
    }
    runners_.renumber(renumbered, id);
}

} // namespace frostfill
