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

void BroadPhase::findPairs(std::span<Runner> runners)
{
    if (runners.size() <= kFewRunners)
    {
        findAmongAll(runners);
        return;
    }
    grid_.rebuild(runners);
    threads_.forEach(runners.size(), [&](std::size_t i) { findInGrid(runners, runners[i]); });
}

void BroadPhase::findAmongAll(std::span<Runner> runners)
{
    balls_.clear();
    for (Runner& runner : runners)
    {
        runner.nearby.clear();
        balls_.push_back({runner.position, runner.radius});
    }
    for (std::uint32_t i = 1; i < balls_.size(); ++i)
    {
        for (std::uint32_t k = 0; k < i; ++k)
        {
            if (mayTouch(balls_[i].centre, balls_[i].radius, balls_[k].centre, balls_[k].radius))
            {
                runners[i].nearby.push_back(k);
                runners[k].nearby.push_back(i);
            }
        }
    }
}

void BroadPhase::findInGrid(std::span<const Runner> runners, Runner& runner) const
{
    runner.nearby.clear();
    grid_.forEachNear(runner.position, runner.radius + 1 + kPairMargin,
                      [&](std::uint32_t k, const Eigen::Vector3d& p, double radius)
                      {
                          if (mayTouch(runner.position, runner.radius, p, radius) &&
                              &runners[k] != &runner)
                          {
                              runner.nearby.push_back(k);
                          }
                      });
    std::sort(runner.nearby.begin(), runner.nearby.end());
}

} // namespace frostfill
