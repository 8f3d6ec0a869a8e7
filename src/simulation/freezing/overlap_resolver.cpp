// SPDX-License-Identifier: MIT
#include "simulation/freezing/overlap_resolver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>
#include <iterator>

namespace frostfill
{

bool OverlapResolver::lookForOverlapped(std::uint32_t row, const PlacedSphere& resting)
{
    Room& room = ahead_[row];
    findOverlapped(row, resting, room.overlapped);
    room.lookedAt = grid_.buildCount();
    return !room.overlapped.empty();
}

void OverlapResolver::lookForRoom(std::uint32_t row, const PlacedSphere& resting, double farthest)
{
    Room& room = ahead_[row];
    findRoom(resting, farthest, room);
    room.atRest = world_.spheres.resting().size();
    room.foundAt = grid_.buildCount();
}

void OverlapResolver::findOverlapped(std::uint32_t row, const PlacedSphere& resting,
                                     std::vector<std::uint32_t>& overlapped) const
{
    overlapped.clear();
    grid_.forEachNear(resting.place, resting.radius + 1,
                      [&](std::uint32_t k, const Eigen::Vector3d& p, double radiusThere)
                      {
                          const double contact = radiusThere + resting.radius;
                          if (k != row && !running_.isGone(k) &&
                              (p - resting.place).squaredNorm() < contact * contact)
                          {
                              overlapped.push_back(k);
                          }
                      });
    std::sort(overlapped.begin(), overlapped.end());
}

void OverlapResolver::findRoom(const PlacedSphere& resting, double farthest, Room& room) const
{
    room.from.clear();
    room.to.clear();
    room.found = true;
    for (std::size_t i = 0; room.found && i < room.overlapped.size(); ++i)
    {
        const std::uint32_t k = room.overlapped[i];
        const double radius = running_.radius[k];
        room.from.push_back(running_.position[k]);
        room.to.push_back(running_.position[k]);
        room.found = depenetrate(world_, resting, room.to.back(), radius, farthest * radius,
                                 kMovesOutOfWedge);
    }
}

// Nobody that is asked for has moved, and nothing that has come to rest since lies where one of
// them would look for obstacles.
bool OverlapResolver::stillHolds(const Room& ahead, double farthest) const
{
    if (ahead.foundAt != grid_.buildCount() || ahead.overlapped != room_.overlapped)
    {
        return false;
    }
    const SphereGrid& resting = world_.spheres.resting();
    for (std::size_t i = 0; i < ahead.from.size(); ++i)
    {
        const std::uint32_t k = ahead.overlapped[i];
        if (running_.position[k] != ahead.from[i])
        {
            return false;
        }
        const double reach = (1 + farthest) * running_.radius[k];
        for (std::size_t newer = ahead.atRest; newer < resting.size(); ++newer)
        {
            const Ball& ball = resting[static_cast<std::uint32_t>(newer)];
            if (isWithin(ball.position(), ahead.from[i], reach + ball.radius))
            {
                return false;
            }
        }
    }
    return true;
}

// As long as none has been put elsewhere, those in the way are those that were, without those that
// have come to rest.
void OverlapResolver::findOverlapped(std::uint32_t row, const PlacedSphere& resting)
{
    if (row >= ahead_.size() || ahead_[row].lookedAt != grid_.buildCount() ||
        stirredAt_ == grid_.buildCount())
    {
        findOverlapped(row, resting, room_.overlapped);
        return;
    }
    room_.overlapped.clear();
    std::copy_if(ahead_[row].overlapped.begin(), ahead_[row].overlapped.end(),
                 std::back_inserter(room_.overlapped),
                 [this](std::uint32_t k) { return !running_.isGone(k); });
}

bool OverlapResolver::moveAside(std::uint32_t row, const PlacedSphere& resting, double farthest)
{
    findOverlapped(row, resting);
    if (room_.overlapped.empty())
    {
        return true;
    }
    if (row < ahead_.size() && stillHolds(ahead_[row], farthest))
    {
        room_.to = ahead_[row].to;
        room_.found = ahead_[row].found;
    }
    else
    {
        findRoom(resting, farthest, room_);
    }
    for (std::size_t i = 0; room_.found && i < room_.overlapped.size(); ++i)
    {
        put(room_.overlapped[i], room_.to[i]);
    }
    return room_.found;
}

void OverlapResolver::evict()
{
    const ReleaseQuery query = {.suits = [this](const Eigen::Vector3d& place, double radius)
                                { return grid_.isClear(place, radius); }};
    for (const std::uint32_t k : room_.overlapped)
    {
        const double radius = running_.radius[k];
        Eigen::Vector3d clear = running_.position[k];
        if (depenetrate(world_, clear, radius, kFarRoom * radius))
        {
            put(k, clear);
        }
        else if (const auto elsewhere = observers_.release->place(radius, query))
        {
            running_.restart(k, *elsewhere);
            grid_.move(k, *elsewhere);
            stirredAt_ = grid_.buildCount();
        }
        else
        {
            withdraw(k);
        }
    }
}

void OverlapResolver::put(std::uint32_t row, const Eigen::Vector3d& place)
{
    running_.position[row] = place;
    flight_.around(row).invalidate(); // what comes to rest is told where it is now
    grid_.move(row, place);
    stirredAt_ = grid_.buildCount();
}

void OverlapResolver::withdraw(std::uint32_t row)
{
    world_.spheres.withdraw(running_.id[row]);
    for (Room& room : ahead_)
    {
        room.foundAt = 0; // what is at rest may be met in another order now
    }
}

} // namespace frostfill
