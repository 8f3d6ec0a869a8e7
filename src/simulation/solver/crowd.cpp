// SPDX-License-Identifier: MIT
#include "simulation/solver/crowd.hpp"

#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

namespace frostfill
{

// An order of all numbers: the guard finds what is not finite at the end of the step, not a sort.
bool Crowd::isBelow(const Member& a, const Member& b)
{
    const auto order = std::weak_order(a.height, b.height);
    return std::is_lt(order) || (std::is_eq(order) && a.row < b.row);
}

void Crowd::gather(const Eigen::Vector3d& down)
{
    down_ = down;
    gathered_.clear();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        if (pairs_.isPaired(row))
        {
            enter(row);
        }
    }
    arrange();
}

void Crowd::gather(std::span<const std::uint32_t> rows, const Eigen::Vector3d& down)
{
    down_ = down;
    gathered_.clear();
    for (const std::uint32_t row : rows)
    {
        enter(row);
    }
    arrange();
}

void Crowd::enter(std::uint32_t row)
{
    gathered_.push_back({-running_.position[row].dot(down_), row, 0});
}

void Crowd::arrange()
{
    cut();
    sortIntoSlabs();
    const std::size_t size = gathered_.size();
    balls_.resize(size);
    rows_.resize(size);
    firstNear_.resize(size);
    nearCount_.resize(size);
    slot_.assign(running_.size(), kNone);
    std::size_t first = 0;
    for (std::uint32_t slot = 0; slot < size; ++slot)
    {
        rows_[slot] = members_.values()[slot].row;
        slot_[rows_[slot]] = slot;
        firstNear_[slot] = first;
        first += pairs_.nearby(rows_[slot]).size();
    }
    nearby_.resize(first);
    forEachMember([this](std::uint32_t slot) { enlist(slot); });
}

// Along the longer side of the crowd across the pull, which gives the most slabs.
void Crowd::cut()
{
    slabs_.assign(1, {0, 0});
    const std::size_t most = gathered_.size() / kFewestInSlab;
    if (most < kFewestSlabs)
    {
        return;
    }
    const auto& places = running_.position;
    Eigen::Vector3d low = places[gathered_[0].row];
    Eigen::Vector3d high = low;
    for (const Member& one : gathered_)
    {
        const Eigen::Vector3d& p = places[one.row];
        if (!p.allFinite())
        {
            return;
        }
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const auto across = [&](int axis)
    { return (high[axis] - low[axis]) * (1 - std::abs(down_[axis])); };
    const int axis = across(0) > across(2) ? 0 : 2;
    const double length = high[axis] - low[axis];
    const double fit = length / (2 * kBeyondRounding * longestPair(axis));
    if (!(fit >= kFewestSlabs))
    {
        return;
    }
    const std::size_t count =
        fit < static_cast<double>(most) ? static_cast<std::size_t>(fit) : most;
    slabs_.assign(count, {0, 0});
    for (Member& one : gathered_)
    {
        const double share = (places[one.row][axis] - low[axis]) / length;
        const auto slab = static_cast<std::size_t>(share * static_cast<double>(count));
        one.slab = static_cast<std::uint32_t>(std::min(slab, count - 1));
    }
}

double Crowd::longestPair(int axis) const
{
    std::vector<double> longest((gathered_.size() + kFewestInSlab - 1) / kFewestInSlab, 0);
    const auto& places = running_.position;
    forEachPart(threads_, gathered_.size(), kFewestInSlab,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    for (std::size_t k = first; k < last; ++k)
                    {
                        const double here = places[gathered_[k].row][axis];
                        for (const std::uint32_t other : pairs_.nearby(gathered_[k].row))
                        {
                            const double way = std::abs(places[other][axis] - here);
                            longest[part] = std::max(longest[part], way);
                        }
                    }
                });
    return *std::max_element(longest.begin(), longest.end());
}

void Crowd::sortIntoSlabs()
{
    members_ = Buckets<Member>(slabs_.size(),
                               [this](auto&& enter)
                               {
                                   for (const Member& one : gathered_)
                                   {
                                       enter(one.slab, one);
                                   }
                               });
    threads_.forEachLarge(slabs_.size(),
                          [this](std::size_t k)
                          {
                              slabs_[k] = {members_.starts()[k], members_.starts()[k + 1]};
                              const std::span<Member> slab = members_[k];
                              std::sort(slab.begin(), slab.end(), isBelow);
                          });
}

void Crowd::enlist(std::uint32_t slot)
{
    balls_[slot].radius = running_.radius[rows_[slot]];
    follow(slot);
    Near* const first = nearby_.data() + firstNear_[slot];
    Near* next = first;
    for (const std::uint32_t row : pairs_.nearby(rows_[slot]))
    {
        const std::uint32_t other = slot_[row];
        if (other != kNone)
        {
            *next++ = {other & kLargestSlot,
                       isBelow(members_.values()[other], members_.values()[slot])};
        }
    }
    nearCount_[slot] = static_cast<std::uint32_t>(next - first);
}

} // namespace frostfill
