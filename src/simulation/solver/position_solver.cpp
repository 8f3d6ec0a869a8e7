// SPDX-License-Identifier: MIT
#include "simulation/solver/position_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace frostfill
{

namespace
{

/// Members whose neighbourhood is asked for before it is needed. Rows lie in memory as they were
/// released, not from below.
constexpr std::uint32_t kAhead = 4;

/// Members that are pushed say so to those nearby, of other strips as well, where several may at
/// once. Who looks whether it was told has waited for those.
std::atomic_ref<char> flag(char& value)
{
    return std::atomic_ref<char>(value);
}

} // namespace

void PositionSolver::resolve(double dt, const Observe& observe)
{
    down_ = flight_.down();
    pairs_.findPairs(
        [&](std::uint32_t row)
        {
            if (!pairs_.isPaired(row))
            {
                observe(row);
            }
        });
    crowd_.gather(down_);
    crowd_.arrange();
    start();
    resolveCrowd(dt, observe);
}

void PositionSolver::resolveCrowd(double dt, const Observe& observe)
{
    if (crowd_.size() == 0)
    {
        return;
    }
    flown_.resize(crowd_.size());
    velocitySolver_.start(down_);
    const int mutual = settings_.stiff ? settings_.sweeps / 4 : settings_.sweeps * 3 / 4;
    const Sweeps sweeps = {settings_.sweeps, settings_.tolerance, kDeep,
                           [mutual](int sweep) { return sweep <= mutual; }};
    crowd_.forEachStrip(
        [&](std::size_t strip)
        {
            crowd_.enlist(strip);
            turns_.meet();
            turns_.findTurns(strip);
            crowd_.forEachMember(
                strip,
                [this](std::uint32_t slot) {
                    flown_[slot] = {crowd_[slot].position(), running_.velocity[crowd_.row(slot)]};
                });
            velocitySolver_.findContacts(strip, dt);
            turns_.meet();
            velocitySolver_.resolve(strip);
            sweep(strip, sweeps);
            crowd_.forEachMember(strip,
                                 [&](std::uint32_t slot)
                                 {
                                     removeLiftEnergy(slot);
                                     observe(crowd_.row(slot));
                                 });
        });
}

void PositionSolver::separate()
{
    for (int k = 0; k < kMaxSeparations; ++k)
    {
        gatherAll();
        crowd_.forEachStrip(
            [&](std::size_t strip)
            {
                crowd_.enlist(strip);
                turns_.meet();
                sweep(strip, {1, 0, 0, [k](int) { return k % 2 == 1; }});
            });
        const auto end = deepest_.begin() + static_cast<std::ptrdiff_t>(crowd_.strips().size());
        if (std::all_of(deepest_.begin(), end, [](double depth) { return depth < kApart; }))
        {
            return;
        }
    }
}

void PositionSolver::separate(std::span<const std::uint32_t> some)
{
    crowd_.gather(some, down_);
    crowd_.arrange();
    start();
    crowd_.forEachStrip(
        [&](std::size_t strip)
        {
            crowd_.enlist(strip);
            turns_.meet();
            sweep(strip, {kMaxSeparations, kApart, kDeep, [](int k) { return k % 2 == 1; }});
        });
}

// All that follows concerns only runners in pairs; what is at rest none of them overlaps.
void PositionSolver::gatherAll()
{
    pairs_.findPairs();
    crowd_.gather(down_);
    crowd_.arrange();
    start();
}

void PositionSolver::start()
{
    turns_.start();
    clear_.assign(crowd_.size(), 0);
    deepest_.resize(std::max(deepest_.size(), crowd_.strips().size()));
}

// A strip in which spheres are still deep goes on without having heard of the others.
void PositionSolver::sweep(std::size_t strip, const Sweeps& sweeps)
{
    for (int k = 0; k < sweeps.most; ++k)
    {
        const std::uint32_t number = kFirstOfPositions + static_cast<std::uint32_t>(k);
        deepest_[strip] = sweepOnce(strip, number, sweeps.isMutual(k) ? 1 : 0, sweeps.liftDepth);
        const bool isDeep = deepest_[strip] >= sweeps.tolerance;
        if (k + 1 < sweeps.most && turns_.isLast(strip, number, isDeep))
        {
            break;
        }
    }
}

// From below: a runner gives way by its share to those above it, whose turn is yet to come, and
// takes what is left of the overlap with those below, so that one sweep lifts a whole pile off its
// floor. Returns the deepest penetration that it found.
double PositionSolver::sweepOnce(std::size_t strip, std::uint32_t number, double yieldShare,
                                 double liftDepth)
{
    double deepest = 0;
    const std::uint32_t end = crowd_.strips()[strip].end;
    for (std::uint32_t slot = crowd_.strips()[strip].begin; slot < end; ++slot)
    {
        if (slot + kAhead < end)
        {
            flight_.prefetch(crowd_.row(slot + kAhead));
        }
        turns_.awaitLower(slot, number);
        if (number > kFirstOfPositions)
        {
            turns_.awaitUpper(slot, number - 1);
        }
        if (flag(clear_[slot]).load(std::memory_order_relaxed) == 0)
        {
            const auto push = pushOff(slot, yieldShare, liftDepth, deepest);
            flag(clear_[slot]).store(push ? 0 : 1, std::memory_order_relaxed);
            if (push && !push->isZero(0))
            {
                flight_.shift(crowd_.row(slot), *push);
                crowd_.follow(slot);
                for (const Crowd::Near& near : crowd_.near(slot))
                {
                    flag(clear_[near.slot]).store(0, std::memory_order_relaxed);
                }
            }
        }
        turns_.endTurn(slot, number);
    }
    return deepest;
}

std::optional<Eigen::Vector3d> PositionSolver::pushOff(std::uint32_t slot, double yieldShare,
                                                       double liftDepth, double& deepest) const
{
    const double radius = crowd_[slot].radius;
    const Eigen::Vector3d before = crowd_[slot].position();
    Eigen::Vector3d place = before;
    double deepestHere = deepest;
    bool touches = false;
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
        touches = true;
        const Contact contact = contactOfSpheres(way, squared, reach);
        const double depth = contact.depth;
        deepestHere = std::max(deepestHere, depth);
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
    if (!touches)
    {
        return std::nullopt;
    }
    deepest = deepestHere;
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
