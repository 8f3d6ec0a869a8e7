// SPDX-License-Identifier: MIT
#include "simulation/freezing/overlap_resolver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>

namespace frostfill
{

void OverlapResolver::findOverlapped(std::uint32_t row, const PlacedSphere& resting)
{
    overlapped_.clear();
    grid_.forEachNear(
        resting.place, resting.radius + 1,
        [&](std::uint32_t k)
        {
            const Ball& other = grid_[k];
            if (k != row && !running_.isGone(k) &&
                isWithin(other.position(), resting.place, other.radius + resting.radius))
            {
                overlapped_.push_back(k);
            }
        });
    std::sort(overlapped_.begin(), overlapped_.end());
}

bool OverlapResolver::moveAside(std::uint32_t row, const PlacedSphere& resting, double farthest)
{
    findOverlapped(row, resting);
    to_.clear();
    for (const std::uint32_t k : overlapped_)
    {
        const double radius = running_.radius[k];
        Eigen::Vector3d& place = to_.emplace_back(running_.position[k]);
        if (!depenetrate(world_, resting, place, radius, farthest * radius, kMovesOutOfWedge))
        {
            return false;
        }
    }
    for (std::size_t i = 0; i < to_.size(); ++i)
    {
        put(overlapped_[i], to_[i]);
    }
    return true;
}

void OverlapResolver::evict()
{
    const ReleaseQuery query = {.suits = [this](const Eigen::Vector3d& place, double radius)
                                { return isClearOf(grid_, place, radius); }};
    for (const std::uint32_t k : overlapped_)
    {
        const double radius = running_.radius[k];
        Eigen::Vector3d clear = running_.position[k];
        if (depenetrate(world_, clear, radius, kFarRoom * radius))
        {
            put(k, clear);
        }
        else if (const auto elsewhere = release_->place(radius, query))
        {
            running_.restart(k, *elsewhere);
            grid_.move(k, *elsewhere);
        }
        else
        {
            world_.spheres.withdraw(running_.id[k]);
        }
    }
}

void OverlapResolver::put(std::uint32_t row, const Eigen::Vector3d& place)
{
    running_.position[row] = place;
    flight_.around(row).invalidate(); // what comes to rest is told where it is now
    grid_.move(row, place);
}

} // namespace frostfill
