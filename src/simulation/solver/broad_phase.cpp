// SPDX-License-Identifier: MIT
#include "simulation/solver/broad_phase.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

bool mayTouch(const Eigen::Vector3d& a, double radiusOfA, const Eigen::Vector3d& b,
              double radiusOfB)
{
    return isWithin(a, b, radiusOfA + radiusOfB + kPairMargin);
}

} // namespace

void BroadPhase::findPairs()
{
    if (running_.size() <= kFewRunners)
    {
        findAmongAll();
        return;
    }
    grid_.rebuild(running_);
    threads_.forEach(running_.size(),
                     [&](std::size_t i) { findInGrid(static_cast<std::uint32_t>(i)); });
}

void BroadPhase::findAmongAll()
{
    const std::span<const Eigen::Vector3d> position = running_.position.all();
    const std::span<const double> radius = running_.radius.all();
    for (std::uint32_t i = 0; i < position.size(); ++i)
    {
        nearby_[i].clear();
        for (std::uint32_t k = 0; k < i; ++k)
        {
            if (mayTouch(position[i], radius[i], position[k], radius[k]))
            {
                nearby_[i].push_back(k);
                nearby_[k].push_back(i);
            }
        }
    }
}

void BroadPhase::findInGrid(std::uint32_t row)
{
    const Eigen::Vector3d& position = running_.position[row];
    const double radius = running_.radius[row];
    std::vector<std::uint32_t>& nearby = nearby_[row];
    nearby.clear();
    grid_.forEachNear(position, radius + 1 + kPairMargin,
                      [&](std::uint32_t k, const Eigen::Vector3d& p, double radiusThere)
                      {
                          if (mayTouch(position, radius, p, radiusThere) && k != row)
                          {
                              nearby.push_back(k);
                          }
                      });
    std::sort(nearby.begin(), nearby.end());
}

} // namespace frostfill
