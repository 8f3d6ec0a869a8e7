// SPDX-License-Identifier: MIT
#include "simulation/solver/position_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

void PositionSolver::resolve(std::span<Runner> runners, double dt)
{
    down_ = flight_.down();
    findPairs(runners);
    velocitySolver_.resolve(runners, crowd_, down_, dt);
    const int mutual = settings_.stiff ? settings_.sweeps / 4 : settings_.sweeps * 3 / 4;
    for (int k = 0; k < settings_.sweeps; ++k)
    {
        if (sweep(runners, k <= mutual ? 1 : 0, kDeep) < settings_.tolerance)
        {
            break;
        }
    }
    payForLifts(runners);
}

void PositionSolver::separate(std::span<Runner> runners)
{
    for (int k = 0; k < kMostSeparations; ++k)
    {
        findPairs(runners);
        if (sweep(runners, k % 2, 0) < kApart)
        {
            return;
        }
    }
}

void PositionSolver::separate(std::span<Runner> runners, std::span<const std::uint32_t> some)
{
    for (Runner& runner : runners)
    {
        runner.rank = Runner::kNobody;
    }
    crowd_.assign(some.begin(), some.end());
    orderFromBelow(runners);
    for (int k = 0; k < kMostSeparations; ++k)
    {
        if (sweep(runners, k % 2, kDeep) < kApart)
        {
            return;
        }
    }
}

// All that follows concerns only runners in pairs; what is at rest none of them overlaps.
void PositionSolver::findPairs(std::span<Runner> runners)
{
    broadPhase_.findPairs(runners);
    for (Runner& runner : runners)
    {
        runner.flown = runner.position;
        runner.velocityBefore = runner.velocity;
    }
    crowd_.clear();
    for (std::size_t i = 0; i < runners.size(); ++i)
    {
        if (!runners[i].nearby.empty())
        {
            crowd_.push_back(static_cast<std::uint32_t>(i));
        }
    }
    orderFromBelow(runners);
}

void PositionSolver::orderFromBelow(std::span<Runner> runners)
{
    for (const std::uint32_t k : crowd_)
    {
        runners[k].height = -runners[k].position.dot(down_);
    }
    std::sort(crowd_.begin(), crowd_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const double ha = runners[a].height;
                  const double hb = runners[b].height;
                  return ha < hb || (ha == hb && a < b);
              });
    for (std::uint32_t rank = 0; rank < crowd_.size(); ++rank)
    {
        runners[crowd_[rank]].rank = rank;
    }
}

// From below: a runner gives way by its share to those above it, whose turn is yet to come, and
// takes what is left of the overlap with those below, so that one sweep lifts a whole pile off its
// floor. Returns the deepest penetration that it found.
double PositionSolver::sweep(std::span<Runner> runners, double giveWay, double climbFrom)
{
    double deepest = 0;
    for (const std::uint32_t k : crowd_)
    {
        Runner& runner = runners[k];
        const Eigen::Vector3d push = pushOff(runners, runner, giveWay, climbFrom, deepest);
        if (!push.isZero(0))
        {
            flight_.shift(runner, push);
        }
    }
    return deepest;
}

Eigen::Vector3d PositionSolver::pushOff(std::span<const Runner> runners, const Runner& runner,
                                        double giveWay, double climbFrom, double& deepest) const
{
    Eigen::Vector3d place = runner.position;
    for (const std::uint32_t k : runner.nearby)
    {
        const Runner& other = runners[k];
        const auto contact = sphereContact(place - other.position, runner.radius + other.radius);
        if (!contact || other.rank == Runner::kNobody)
        {
            continue;
        }
        const double depth = contact->depth;
        deepest = std::max(deepest, depth);
        const bool takesRest = other.rank < runner.rank && (runner.yields || !other.yields);
        const double share = takesRest ? 1 : giveWay * shareOf(runner, other, down_);
        Eigen::Vector3d away = contact->normal;
        if (takesRest && depth > climbFrom * runner.radius)
        {
            // Spheres pressed into a row on the floor or in a corner leave it upwards.
            away = (away - down_ * (depth / runner.radius - climbFrom)).normalized();
        }
        place += away * (share * depth);
    }
    const Eigen::Vector3d push = place - runner.position;
    const double length = push.norm();
    const double longest = kLongestPush * runner.radius;
    return length > longest ? Eigen::Vector3d(push * (longest / length)) : push;
}

// What is lifted is slowed down by as much energy.
void PositionSolver::payForLifts(std::span<Runner> runners) const
{
    for (const std::uint32_t k : crowd_)
    {
        Runner& runner = runners[k];
        const double fall = (runner.position - runner.flown)
                                .dot(flight_.pullAt(runner.flown, runner.velocityBefore));
        const double squared = runner.velocity.squaredNorm();
        if (fall < 0 && squared > 0)
        {
            runner.velocity *= std::sqrt(std::max(0.0, 1 + 2 * fall / squared));
        }
    }
}

} // namespace frostfill
