// SPDX-License-Identifier: MIT
#include <simulation/encounters.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kMeetingMargin = 0.3; // gap up to which runners may meet within a step [r]
constexpr double kLongestPush = 0.2;   // in one sweep, of the own radius
constexpr double kApart = 1e-8;        // penetration depth that is left to those taken apart [r]
constexpr int kMostSeparations = 1000; // sweeps
// Runners from which on pushes are worth sharing: those that push each other share memory, too.
constexpr std::size_t kManyRunners = 4096;

// How much of the penetration depth a gives way by. One that nothing at rest has carried for long
// stops giving way, so that it comes down to something that does; of two such, the lower.
double shareOf(const Runner& a, const Runner& b, const Eigen::Vector3d& down)
{
    if (a.yields != b.yields)
    {
        return a.yields ? 1 : 0;
    }
    if (!a.yields)
    {
        const double ya = -a.position.dot(down);
        const double yb = -b.position.dot(down);
        return ya < yb || (ya == yb && a.id < b.id) ? 0 : 1;
    }
    const double ma = a.radius * a.radius * a.radius;
    const double mb = b.radius * b.radius * b.radius;
    return mb / (ma + mb);
}

} // namespace

void Encounters::resolve(std::span<Runner> runners, double dt)
{
    down_ = flight_.down();
    findMeetings(runners);
    for (int k = 0; k < settings_.sweeps; ++k)
    {
        if (sweep(runners) < settings_.tolerance)
        {
            break;
        }
    }
    updateVelocities(runners, dt);
}

void Encounters::separate(std::span<Runner> runners)
{
    for (int k = 0; k < kMostSeparations; ++k)
    {
        findMeetings(runners);
        if (sweep(runners) < kApart)
        {
            return;
        }
    }
}

// All that follows concerns only the runners that meet others; what is at rest none of them
// overlaps.
void Encounters::findMeetings(std::span<Runner> runners)
{
    grid_.rebuild(runners);
    threads_.forEach(runners.size(), [&](std::size_t i) { findMeetingsOf(runners, runners[i]); });
    crowd_.clear();
    for (std::size_t i = 0; i < runners.size(); ++i)
    {
        if (!runners[i].meeting.empty())
        {
            crowd_.push_back(static_cast<std::uint32_t>(i));
        }
    }
}

void Encounters::findMeetingsOf(std::span<const Runner> runners, Runner& runner) const
{
    runner.meeting.clear();
    grid_.forEachNear(runner.position, runner.radius + 1 + kMeetingMargin,
                      [&](std::uint32_t k, const Eigen::Vector3d& p, double radius)
                      {
                          const double limit = runner.radius + radius + kMeetingMargin;
                          if ((p - runner.position).squaredNorm() < limit * limit &&
                              &runners[k] != &runner)
                          {
                              runner.meeting.push_back(k);
                          }
                      });
    std::sort(runner.meeting.begin(), runner.meeting.end());
    runner.flown = runner.position;
    runner.velocityBefore = runner.velocity;
}

// Returns the deepest penetration that it found.
double Encounters::sweep(std::span<Runner> runners)
{
    threads_.forEach(
        crowd_.size(), [&](std::size_t i) { pushOff(runners, runners[crowd_[i]]); }, kManyRunners);
    double deepest = 0;
    pushed_.clear();
    for (const std::uint32_t k : crowd_)
    {
        deepest = std::max(deepest, runners[k].depth);
        if (!runners[k].push.isZero(0))
        {
            pushed_.push_back(k);
        }
    }
    threads_.forEach(
        pushed_.size(),
        [&](std::size_t i)
        {
            Runner& runner = runners[pushed_[i]];
            flight_.shift(runner, runner.push);
        },
        kManyRunners);
    return deepest;
}

void Encounters::pushOff(std::span<const Runner> runners, Runner& runner) const
{
    runner.push.setZero();
    runner.depth = 0;
    for (const std::uint32_t k : runner.meeting)
    {
        const Runner& other = runners[k];
        const Eigen::Vector3d d = runner.position - other.position;
        const double contact = runner.radius + other.radius;
        const double squared = d.squaredNorm();
        if (squared >= contact * contact)
        {
            continue;
        }
        const double distance = std::sqrt(squared);
        const double depth = contact - distance;
        runner.depth = std::max(runner.depth, depth);
        if (distance > 0)
        {
            runner.push += d * (shareOf(runner, other, down_) * depth / distance);
        }
        else
        {
            // Two in the same place leave each other along a line; which way, their ids decide.
            runner.push.x() +=
                (runner.id < other.id ? 1 : -1) * shareOf(runner, other, down_) * depth;
        }
    }
    const double length = runner.push.norm();
    const double longest = kLongestPush * runner.radius;
    if (length > longest)
    {
        runner.push *= longest / length;
    }
}

// Velocity from the corrected displacement (position-based dynamics), except where a pair met fast
// enough to bounce: there the relative speed along the normal becomes -e times what it was.
void Encounters::updateVelocities(std::span<Runner> runners, double dt)
{
    for (const std::uint32_t k : crowd_)
    {
        Runner& runner = runners[k];
        // Being pushed may turn a sphere round, but only what it comes down by makes it faster.
        const Eigen::Vector3d push = runner.position - runner.flown;
        const Eigen::Vector3d corrected = runner.velocityBefore + push / dt;
        const double fall = push.dot(flight_.pullAt(runner.flown, runner.velocityBefore));
        const double speed =
            std::sqrt(std::max(0.0, runner.velocityBefore.squaredNorm() + 2 * fall));
        const double length = corrected.norm();
        runner.velocity =
            length > speed ? Eigen::Vector3d(corrected * (speed / length)) : corrected;
    }
    if (settings_.restitution > 0)
    {
        threads_.forEach(
            crowd_.size(), [&](std::size_t i) { bounce(runners, runners[crowd_[i]]); },
            kManyRunners);
    }
}

// As if each pair met alone, with the velocities from before; of several, the mean.
void Encounters::bounce(std::span<const Runner> runners, Runner& runner) const
{
    Eigen::Vector3d change = Eigen::Vector3d::Zero();
    int contacts = 0;
    for (const std::uint32_t k : runner.meeting)
    {
        const Runner& other = runners[k];
        const Eigen::Vector3d d = runner.flown - other.flown;
        const double distance = d.norm();
        if (distance >= runner.radius + other.radius || distance == 0)
        {
            continue;
        }
        const Eigen::Vector3d normal = d / distance;
        const double before = (runner.velocityBefore - other.velocityBefore).dot(normal);
        if (before < -settings_.bounceSpeed)
        {
            change +=
                normal * (-(1 + settings_.restitution) * before * shareOf(runner, other, down_));
            ++contacts;
        }
    }
    if (contacts > 0)
    {
        runner.velocity = runner.velocityBefore + change / contacts;
    }
}

} // namespace frostfill
