// SPDX-License-Identifier: MIT
#include "simulation/solver/position_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{

void PositionSolver::resolve(double dt)
{
    down_ = flight_.down();
    findPairs();
    for (const std::uint32_t row : paired_)
    {
        flown_[row] = running_.position[row];
        velocityBefore_[row] = running_.velocity[row];
    }
    velocitySolver_.resolve(paired_, rank_, down_, dt);
    const int mutual = settings_.stiff ? settings_.sweeps / 4 : settings_.sweeps * 3 / 4;
    for (int k = 0; k < settings_.sweeps; ++k)
    {
        if (sweep(k <= mutual ? 1 : 0, kDeep) < settings_.tolerance)
        {
            break;
        }
    }
    removeLiftEnergy();
}

void PositionSolver::separate()
{
    for (int k = 0; k < kMaxSeparations; ++k)
    {
        findPairs();
        if (sweep(k % 2, 0) < kApart)
        {
            return;
        }
    }
}

void PositionSolver::separate(std::span<const std::uint32_t> some)
{
    rank_.assign(running_.size(), kNotInCrowd);
    paired_.assign(some.begin(), some.end());
    sortByHeight();
    for (int k = 0; k < kMaxSeparations; ++k)
    {
        if (sweep(k % 2, kDeep) < kApart)
        {
            return;
        }
    }
}

// All that follows concerns only runners in pairs; what is at rest none of them overlaps.
void PositionSolver::findPairs()
{
    pairs_.findPairs();
    paired_.clear();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        if (!pairs_.nearby(row).empty())
        {
            paired_.push_back(row);
        }
    }
    sortByHeight();
}

void PositionSolver::sortByHeight()
{
    height_.resize(running_.size());
    rank_.resize(running_.size());
    flown_.resize(running_.size());
    velocityBefore_.resize(running_.size());
    clear_.assign(running_.size(), 0);
    for (const std::uint32_t row : paired_)
    {
        height_[row] = -running_.position[row].dot(down_);
    }
    std::sort(paired_.begin(), paired_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              { return height_[a] < height_[b] || (height_[a] == height_[b] && a < b); });
    for (std::uint32_t rank = 0; rank < paired_.size(); ++rank)
    {
        rank_[paired_[rank]] = rank;
    }
}

// From below: a runner gives way by its share to those above it, whose turn is yet to come, and
// takes what is left of the overlap with those below, so that one sweep lifts a whole pile off its
// floor. Returns the deepest penetration that it found.
double PositionSolver::sweep(double yieldShare, double liftDepth)
{
    double deepest = 0;
    for (const std::uint32_t row : paired_)
    {
        if (clear_[row] != 0)
        {
            continue;
        }
        const auto push = pushOff(row, yieldShare, liftDepth, deepest);
        clear_[row] = push ? 0 : 1;
        if (push && !push->isZero(0))
        {
            flight_.shift(row, *push);
            for (const std::uint32_t other : pairs_.nearby(row))
            {
                clear_[other] = 0;
            }
        }
    }
    return deepest;
}

std::optional<Eigen::Vector3d> PositionSolver::pushOff(std::uint32_t row, double yieldShare,
                                                       double liftDepth, double& deepest) const
{
    const std::span<const Eigen::Vector3d> positions = std::as_const(running_.position).all();
    const std::span<const double> radii = std::as_const(running_.radius).all();
    const double radius = radii[row];
    const std::uint32_t rank = rank_[row];
    Eigen::Vector3d place = positions[row];
    double deepestHere = deepest;
    bool touches = false;
    for (const std::uint32_t other : pairs_.nearby(row))
    {
        const auto contact = sphereContact(place - positions[other], radius + radii[other]);
        if (!contact || rank_[other] == kNotInCrowd)
        {
            continue;
        }
        touches = true;
        const double depth = contact->depth;
        deepestHere = std::max(deepestHere, depth);
        const bool takesRest =
            rank_[other] < rank && (velocitySolver_.yields(row) || !velocitySolver_.yields(other));
        const double share =
            takesRest ? 1 : yieldShare * velocitySolver_.shareOf(row, other, down_);
        Eigen::Vector3d away = contact->normal;
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
    const Eigen::Vector3d push = place - positions[row];
    const double length = push.norm();
    const double longest = kLongestPush * radius;
    return length > longest ? Eigen::Vector3d(push * (longest / length)) : push;
}

// What is lifted is slowed down by as much energy.
void PositionSolver::removeLiftEnergy()
{
    for (const std::uint32_t row : paired_)
    {
        Eigen::Vector3d& velocity = running_.velocity[row];
        const double fall = (running_.position[row] - flown_[row])
                                .dot(flight_.pullAt(flown_[row], velocityBefore_[row]));
        const double squared = velocity.squaredNorm();
        if (fall < 0 && squared > 0)
        {
            velocity *= std::sqrt(std::max(0.0, 1 + 2 * fall / squared));
        }
    }
}

} // namespace frostfill
