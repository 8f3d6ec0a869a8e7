// SPDX-License-Identifier: MIT
#include "simulation/solver/ordered_loop.hpp"

#include <numeric>

namespace frostfill
{

void OrderedLoop::prepare(std::span<const std::uint32_t> rows, std::span<const std::uint32_t> rank)
{
    slots_.resize(rank.size());
    if (rows.size() < kWorthSharing || threads_.concurrency() == 1)
    {
        regions_.clear();
        order_.assign(rows.begin(), rows.end());
    }
    else
    {
        divide(rows);
    }
    for (std::uint32_t slot = 0; slot < order_.size(); ++slot)
    {
        slots_[order_[slot]] = slot;
    }
    threads_.forEachLarge(regions_.size(), [&](std::size_t region)
                          { findNeeds(static_cast<std::uint32_t>(region), rank); });
}

// Slabs along x with as many runners each.
void OrderedLoop::divide(std::span<const std::uint32_t> rows)
{
    const std::size_t count = threads_.concurrency();
    while (regions_.size() < count)
    {
        regions_.emplace_back();
    }
    borders_.clear();
    for (const std::uint32_t row : rows)
    {
        borders_.push_back(running_.position[row].x());
    }
    std::sort(borders_.begin(), borders_.end());
    for (std::size_t k = 1; k < count; ++k)
    {
        borders_[k - 1] = borders_[rows.size() * k / count];
    }
    borders_.resize(count - 1);

    regionOf_.resize(slots_.size());
    std::vector<std::uint32_t> next(count + 1, 0);
    for (const std::uint32_t row : rows)
    {
        const auto border =
            std::upper_bound(borders_.begin(), borders_.end(), running_.position[row].x());
        regionOf_[row] = static_cast<std::uint32_t>(border - borders_.begin());
        ++next[regionOf_[row] + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t k = 0; k < count; ++k)
    {
        regions_[k].first = next[k];
        regions_[k].end = next[k + 1];
    }
    order_.resize(rows.size());
    for (const std::uint32_t row : rows)
    {
        order_[next[regionOf_[row]]++] = row;
    }
}

// Of those in one other region the last is enough.
void OrderedLoop::findNeeds(std::uint32_t region, std::span<const std::uint32_t> rank)
{
    Region& its = regions_[region];
    its.needs.clear();
    for (std::uint32_t slot = its.first; slot < its.end; ++slot)
    {
        const std::uint32_t row = order_[slot];
        const std::size_t before = its.needs.size();
        for (const std::uint32_t other : pairs_.nearby(row))
        {
            if (rank[other] > rank[row] || regionOf_[other] == region)
            {
                continue;
            }
            const auto same = std::find_if(
                its.needs.begin() + static_cast<std::ptrdiff_t>(before), its.needs.end(),
                [&](const Need& need) { return need.region == regionOf_[other]; });
            if (same == its.needs.end())
            {
                its.needs.push_back({slot, regionOf_[other], slots_[other]});
                continue;
            }
            same->before = std::max(same->before, slots_[other]);
        }
    }
}

void OrderedLoop::start()
{
    for (Region& region : regions_)
    {
        region.next = region.first;
        region.met = 0;
    }
    left_ = static_cast<std::size_t>(std::count_if(regions_.begin(), regions_.end(),
                                                   [](const Region& region)
                                                   { return region.first != region.end; }));
    failed_ = false;
}

bool OrderedLoop::waitFor(const Need& need) const
{
    const std::atomic<std::uint32_t>& next = regions_[need.region].next;
    for (int spin = 0; next.load(std::memory_order_acquire) <= need.before; ++spin)
    {
        if (spin == kPatience)
        {
            return false;
        }
        pauseAfter(spin);
    }
    return true;
}

} // namespace frostfill
