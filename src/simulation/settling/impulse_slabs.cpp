// SPDX-License-Identifier: MIT
#include "simulation/settling/impulse_sweeps.hpp"
#include "simulation/solver/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace frostfill
{

void ImpulseSweeps::plan(const std::vector<char>& active, double width)
{
    if (running_.size() == 0)
    {
        return;
    }
    layOut(width);
    placeBodies(active);
    threads_.forEachLarge(slabs_.size(),
                          [&](std::size_t k)
                          {
                              std::sort(slabs_[k].items.begin(), slabs_[k].items.end(),
                                        [](const Item& a, const Item& b) {
                                            return std::tie(a.height, a.isWall, a.index) <
                                                   std::tie(b.height, b.isWall, b.index);
                                        });
                          });
}

// Along the longer side of the pile: more slabs, more threads. Otherwise along z, by which rows
// ascend, so that a slab's spheres lie side by side in memory. Contacts that have grown longer
// since they were listed widen the slabs: so a sphere is in its own slab and in the one below
// alone.
void ImpulseSweeps::layOut(double width)
{
    const auto& places = running_.position;
    Eigen::Vector3d low = places[0];
    Eigen::Vector3d high = places[0];
    for (const Eigen::Vector3d& p : places.all())
    {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Eigen::Vector3d size = high - low;
    const int axis = size.x() > kLongerSide * size.z() ? 0 : 2;
    for (const std::uint32_t k : pairs_.chosen())
    {
        const auto [a, b] = pairs_.rowsOf(k);
        width = std::max(width, kBeyondRounding * std::abs(places[a][axis] - places[b][axis]));
    }
    double last = (high[axis] - low[axis]) / width;
    last = last < kMaxLength ? last : 0; // a sphere is lost, as the guard will find: one slab
    const auto slabOf = [&](std::uint32_t row)
    {
        const double slab = (places[row][axis] - low[axis]) / width;
        return slab > 0 && slab <= last ? static_cast<std::size_t>(slab) : 0;
    };
    slabs_.resize(static_cast<std::size_t>(last) + 1);
    for (Slab& slab : slabs_)
    {
        slab.items.clear();
    }
    for (const std::uint32_t k : pairs_.chosen())
    {
        const auto [a, b] = pairs_.rowsOf(k);
        const double height = (places[a].y() + places[b].y()) / 2;
        slabs_[std::min(slabOf(a), slabOf(b))].items.push_back({height, k, false, 0});
    }
    for (const std::uint32_t k : walls_.chosen())
    {
        const std::uint32_t row = walls_.rowOf(k);
        slabs_[slabOf(row)].items.push_back({places[row].y(), k, true, 0});
    }
}

void ImpulseSweeps::placeBodies(const std::vector<char>& active)
{
    bodies_.assign(running_.size() + slabs_.size(), Body());
    rows_.clear();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        bodies_[row].inverseRadius = 1 / running_.radius[row];
        if (active[row] != 0)
        {
            bodies_[row].inverseMass = 1 / massOf(running_.radius[row]);
            rows_.push_back(row);
        }
    }
}

} // namespace frostfill
