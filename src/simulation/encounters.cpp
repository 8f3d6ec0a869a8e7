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
constexpr int kRounds = 8;             // of collisions
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

// Approach to what is at rest is lost.
void stopAtRest(Runner& runner)
{
    for (const Eigen::Vector3d& normal : runner.normals)
    {
        const double approach = normal.dot(runner.velocity);
        if (approach < 0)
        {
            runner.velocity -= approach * normal;
        }
    }
}

} // namespace

void Encounters::resolve(std::span<Runner> runners)
{
    down_ = flight_.down();
    findMeetings(runners);
    exchangeVelocities(runners);
    for (int k = 0; k < settings_.sweeps; ++k)
    {
        if (sweep(runners) < settings_.tolerance)
        {
            break;
        }
    }
    payForLifts(runners);
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

// Collisions of pairs one after another, the lowest first, and of each with what is at rest: none of
// them adds energy, and a few rounds carry the floor's reaction up a pile.
void Encounters::exchangeVelocities(std::span<Runner> runners)
{
    findContacts(runners);
    for (int round = 0; round < kRounds; ++round)
    {
        for (const Contact& contact : contacts_)
        {
            collide(runners[contact.a], runners[contact.b], contact.normal);
        }
    }
}

// Of those that overlap, the lowest first.
void Encounters::findContacts(std::span<const Runner> runners)
{
    contacts_.clear();
    for (const std::uint32_t k : crowd_)
    {
        for (const std::uint32_t other : runners[k].meeting)
        {
            if (other > k)
            {
                const Runner& a = runners[k];
                const Runner& b = runners[other];
                const Eigen::Vector3d d = a.position - b.position;
                const double contact = a.radius + b.radius;
                const double squared = d.squaredNorm();
                if (squared < contact * contact && squared > 0)
                {
                    contacts_.push_back({k, other, -(a.position + b.position).dot(down_),
                                         d / std::sqrt(squared)});
                }
            }
        }
    }
    std::sort(contacts_.begin(), contacts_.end(),
              [](const Contact& one, const Contact& two)
              {
                  return one.height < two.height ||
                         (one.height == two.height &&
                          std::pair(one.a, one.b) < std::pair(two.a, two.b));
              });
}

void Encounters::collide(Runner& a, Runner& b, const Eigen::Vector3d& normal) const
{
    const double approach = (a.velocity - b.velocity).dot(normal);
    if (approach >= 0)
    {
        return;
    }
    const double e = approach < -settings_.bounceSpeed ? settings_.restitution : 0;
    const double change = -(1 + e) * approach;
    a.velocity += normal * (change * shareOf(a, b, down_));
    b.velocity -= normal * (change * shareOf(b, a, down_));
    stopAtRest(a);
    stopAtRest(b);
}

// What is lifted is slowed down by as much energy.
void Encounters::payForLifts(std::span<Runner> runners) const
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
