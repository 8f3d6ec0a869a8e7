// SPDX-License-Identifier: MIT
#include "simulation/solver/broad_phase.hpp"

#include "bulk/sphere_levels.hpp"
#include "simulation/contact/contact.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>

namespace frostfill
{

namespace
{

/// Whether cells around the places can be counted. Where one of them is not finite or far away, the
/// guard tells at the end of the step.
bool isSmall(std::span<const Eigen::Vector3d> places)
{
    return std::all_of(places.begin(), places.end(),
                       [](const Eigen::Vector3d& p)
                       { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxLength; });
}

} // namespace

bool BroadPhase::mayTouch(const Eigen::Vector3d& a, double radiusOfA, const Eigen::Vector3d& b,
                          double radiusOfB) const
{
    return isWithin(a, b, radiusOfA + radiusOfB + margin_);
}

void BroadPhase::findPairs()
{
    findPairs(running_.radius.all());
}

// In the order of the levels, as neighbours then lie in memory together.
void BroadPhase::findPairs(std::span<const double> radii)
{
    const std::span<const Eigen::Vector3d> position = running_.position.all();
    if (position.size() <= kFewRunners || !isSmall(position))
    {
        findAmongAll(radii);
        return;
    }
    const SphereLevels levels(position, radii);
    threads_.forEachSmall(
        levels.order().size(),
        [&](std::size_t i)
        {
            const std::uint32_t row = levels.order()[i];
            const Eigen::Vector3d& p = position[row];
            std::vector<std::uint32_t>& nearby = nearby_[row];
            nearby.clear();
            levels.forEachNear(
                p, [&](double largest) { return radii[row] + largest + margin_; },
                [&](std::uint32_t other, const Eigen::Vector3d& centre, double radius)
                {
                    if (mayTouch(p, radii[row], centre, radius) && other != row)
                    {
                        nearby.push_back(other);
                    }
                });
            std::sort(nearby.begin(), nearby.end());
        });
}

void BroadPhase::findAmongAll(std::span<const double> radii)
{
    const std::span<const Eigen::Vector3d> position = running_.position.all();
    for (std::uint32_t i = 0; i < position.size(); ++i)
    {
        nearby_[i].clear();
        for (std::uint32_t k = 0; k < i; ++k)
        {
            if (mayTouch(position[i], radii[i], position[k], radii[k]))
            {
                nearby_[i].push_back(k);
                nearby_[k].push_back(i);
            }
        }
    }
}

} // namespace frostfill
