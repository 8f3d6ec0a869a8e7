// SPDX-License-Identifier: MIT
#include "simulation/solver/position_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

void PositionSolver::resolve(double dt)
{
    down_ = flight_.down();
    pairs_.findPairs();
    crowd_.gather(down_);
    flown_.resize(crowd_.size());
    crowd_.forEachMember(
        [this](std::uint32_t slot) {
            flown_[slot] = {crowd_[slot].position(), running_.velocity[crowd_.row(slot)]};
        });
    velocitySolver_.resolve(down_, dt);
    const int mutual = settings_.stiff ? settings_.sweeps / 4 : settings_.sweeps * 3 / 4;
    sweep({settings_.sweeps, settings_.tolerance, kDeep,
           [mutual](int sweep) { return sweep <= mutual; }});
    crowd_.forEachMember([this](std::uint32_t slot) { removeLiftEnergy(slot); });
}

void PositionSolver::separate()
{
    double deepest = kApart;
    for (int k = 0; k < kMaxSeparations && deepest >= kApart; ++k)
    {
        pairs_.findPairs();
        crowd_.gather(down_);
        deepest = sweep({1, 0, 0, [k](int) { return k % 2 == 1; }});
    }
}

void PositionSolver::separate(std::span<const std::uint32_t> some)
{
    crowd_.gather(some, down_);
    sweep({kMaxSeparations, kApart, kDeep, [](int k) { return k % 2 == 1; }});
}

double PositionSolver::sweep(const Sweeps& sweeps)
{
    double deepest = sweeps.tolerance;
    for (int k = 0; k < sweeps.most && deepest >= sweeps.tolerance; ++k)
    {
        deepest = sweepOnce(sweeps.isMutual(k) ? 1 : 0, sweeps.liftDepth);
    }
    return deepest;
}

double PositionSolver::sweepOnce(double yieldShare, double liftDepth)
{
    deepest_.resize(crowd_.slabs().size());
    crowd_.sweep([&](std::size_t k)
                 { deepest_[k] = sweepSlab(crowd_.slabs()[k], yieldShare, liftDepth); });
    return *std::max_element(deepest_.begin(), deepest_.end());
}

// From below: a runner gives way by its share to those above it, whose turn is yet to come, and
// takes what is left of the overlap with those below, so that one sweep lifts a whole pile off its
// floor.
double PositionSolver::sweepSlab(const Crowd::Slab& slab, double yieldShare, double liftDepth)
{
    double deepest = 0;
    for (std::uint32_t slot = slab.begin; slot < slab.end; ++slot)
    {
        const Eigen::Vector3d push = pushOff(slot, yieldShare, liftDepth, deepest);
        if (!push.isZero(0))
        {
            flight_.shift(crowd_.row(slot), push);
            crowd_.follow(slot);
        }
    }
    return deepest;
}

Eigen::Vector3d PositionSolver::pushOff(std::uint32_t slot, double yieldShare, double liftDepth,
                                        double& deepest) const
{
    const double radius = crowd_[slot].radius;
    const Eigen::Vector3d before = crowd_[slot].position();
    Eigen::Vector3d place = before;
    for (const Crowd::Near& near : crowd_.near(slot))
    {
        const Ball& other = crowd_[near.slot];
        const Eigen::Vector3d way = place - other.position();
        const double reach = radius + other.radius;
        const double squared = way.squaredNorm();
        if (squared >= reach * reach)
        {
            continue;
        }
        const Contact contact = contactOfSpheres(way, squared, reach);
        const double depth = contact.depth;
        deepest = std::max(deepest, depth);
        const bool takesRest =
            near.isLower != 0 && (velocitySolver_.yields(crowd_.row(slot)) ||
                                  !velocitySolver_.yields(crowd_.row(near.slot)));
        if (!takesRest && yieldShare == 0)
        {
            continue;
        }
        const double share =
            takesRest ? 1 : yieldShare * velocitySolver_.shareOf(slot, near.slot, down_);
        Eigen::Vector3d away = contact.normal;
        if (takesRest && depth > liftDepth * radius)
        {
            // Spheres pressed into a row on the floor or in a corner leave it upwards.
            away = (away - down_ * (depth / radius - liftDepth)).normalized();
        }
        place += away * (share * depth);
    }
    const Eigen::Vector3d push = place - before;
    const double length = push.norm();
    const double longest = kLongestPush * radius;
    return length > longest ? Eigen::Vector3d(push * (longest / length)) : push;
}

// What is lifted is slowed down by as much energy.
void PositionSolver::removeLiftEnergy(std::uint32_t slot)
{
    const auto& [position, velocityBefore] = flown_[slot];
    Eigen::Vector3d& velocity = running_.velocity[crowd_.row(slot)];
    const double fall =
        (crowd_[slot].position() - position).dot(flight_.pullAt(position, velocityBefore));
    const double squared = velocity.squaredNorm();
    if (fall < 0 && squared > 0)
    {
        velocity *= std::sqrt(std::max(0.0, 1 + 2 * fall / squared));
    }
}

} // namespace frostfill
