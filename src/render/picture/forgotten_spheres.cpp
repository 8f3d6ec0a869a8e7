// SPDX-License-Identifier: MIT
#include "render/picture/sphere_draw_list.hpp"

#include <bit>
#include <utility>

/// Which spheres a list of those to draw forgets, and how they come back.
namespace frostfill
{
namespace
{

SphereState stateOf(const SphereInstance& sphere)
{
    return static_cast<SphereState>(sphere.state & 0xffU);
}

} // namespace

std::uint32_t SphereDrawList::placeOfForgotten(const SphereInstance& sphere)
{
    std::uint64_t hash = 0;
    for (const float number : {sphere.x, sphere.y, sphere.z, sphere.radius})
    {
        hash = (hash ^ std::bit_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32;
    }
    constexpr std::uint32_t kHash = kForgotten - 2; // so that it is not kRuns
    return kForgotten | (static_cast<std::uint32_t>(hash) & kHash);
}

std::vector<std::uint32_t> SphereDrawList::forget(const std::vector<bool>& seen)
{
    if (order_.empty())
    {
        order_ = restingIds_;
    }
    std::vector<std::uint32_t> now(resting_.size(), kForgotten);
    std::vector<SphereInstance> spheres; // no larger than need be
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < resting_.size(); ++i)
    {
        if (seen[i] || stateOf(resting_[i]) != SphereState::discarded)
        {
            now[i] = static_cast<std::uint32_t>(spheres.size());
            spheres.push_back(resting_[i]);
            ids.push_back(restingIds_[i]);
        }
        places_[restingIds_[i]] = now[i] != kForgotten ? now[i] : placeOfForgotten(resting_[i]);
    }
    resting_ = std::move(spheres);
    restingIds_ = std::move(ids);
    forgetFrom_ = std::max(kForgetFrom, 2 * resting_.size());
    return now;
}

// As if none had been forgotten, in the same order.
void SphereDrawList::bringBack(const Snapshot& snapshot)
{
    const std::size_t arrivals = resting_.size() - changes_.firstArrival;
    std::vector<SphereInstance> all;
    all.reserve(order_.size());
    for (const std::uint32_t id : order_)
    {
        all.push_back(isForgotten(id) ? instance(snapshot, id) : resting_[places_[id]]);
        places_[id] = static_cast<std::uint32_t>(all.size() - 1);
    }
    resting_ = std::move(all);
    restingIds_ = std::exchange(order_, {});
    changes_.firstArrival = resting_.size() - arrivals;
    changes_.recoloured.clear(); // all are drawn anew
}

} // namespace frostfill
