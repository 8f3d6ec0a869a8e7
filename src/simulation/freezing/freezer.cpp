// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezer.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>
#include <compare>
#include <iterator>
#include <limits>
#include <map>

namespace frostfill
{

Freezer::Freezer(World& world, SphereGrid& grid, const std::unique_ptr<ReleasePart>& release,
                 FreeFlight& flight, PositionSolver& solver, Threads& threads, double ageLimit)
    : world_(world), running_(world.spheres.running()), grid_(grid), release_(release),
      flight_(flight), solver_(solver), threads_(threads), dropAndRoll_(world),
      island_(running_, flight, solver.pairs(), threads), resolver_(world, grid, flight, release),
      support_(world), ageLimit_(ageLimit), layer_(spheresInLayer(world)),
      watch_(running_, [this](std::uint32_t row, RestWatch& watch)
             { watch = {.start = running_.position[row]}; })
{
}

void Freezer::startWindow()
{
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        watch_[row].start = running_.position[row];
    }
}

void Freezer::freeze(SetSchedule& sets)
{
    carriedAt_.resize(running_.size());
    stale_.resize(running_.size());
    findSleepy();
    sets.endWindow(watch_.all(), sleepy_);
    if (sleepy_.empty())
    {
        return;
    }
    frozen_.clear();
    gather(grid_, running_);
    if (isPile())
    {
        freezeTogether(sets.keepsSets() ? 1 : kStillInPile);
    }
    freezeOneByOne();
    world_.spheres.closeRanks();
    wakeUncarried();
}

// Whether it was calm in the window that ends, and begins the next one.
void Freezer::watchRow(std::uint32_t row)
{
    RestWatch& watch = watch_[row];
    const double still = kStill * running_.radius[row];
    const double way = (running_.position[row] - watch.start).squaredNorm();
    const double farAgain = kYieldsAgain * running_.radius[row];
    if (flight_.rolls() && way > farAgain * farAgain)
    {
        solver_.velocities().yieldAgain(row);
    }
    const bool calm = way < still * still;
    watch.stillWindows = calm ? watch.stillWindows + 1 : 0;
    watch.start = running_.position[row];
}

void Freezer::findSleepy()
{
    sleepy_.clear();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        watchRow(row);
        if (watch_[row].stillWindows > 0 || isOverdue(row))
        {
            sleepy_.push_back(row);
        }
    }
    const Eigen::Vector3d down = world_.pull.direction(Eigen::Vector3d::Zero());
    std::sort(sleepy_.begin(), sleepy_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const auto order = std::weak_order(-running_.position[a].dot(down),
                                                     -running_.position[b].dot(down)); // NaN, too
                  return order < 0 || (order == 0 && a < b);
              });
}

// Calm spheres that lie on each other as well as on what is at rest, as in a pile that has come to
// rest as a whole. They are frozen where they are, once their overlaps are taken apart.
void Freezer::freezeTogether(std::uint32_t stillWindows)
{
    together_.clear();
    std::copy_if(sleepy_.begin(), sleepy_.end(), std::back_inserter(together_),
                 [&](std::uint32_t row) { return watch_[row].stillWindows >= stillWindows; });
    island_.keep(together_);
    if (together_.empty())
    {
        return;
    }
    solver_.separate(together_);
    gather(grid_, running_);
    island_.keep(together_);
    for (const std::uint32_t row : together_)
    {
        // Those before may have made this one give way, or have failed to freeze.
        if (!running_.isGone(row) && island_.carry(row))
        {
            carriedAt_[row] = running_.position[row];
            tryFreeze(row, true);
        }
        island_.dismiss(row); // at rest or given up
    }
}

// The lowest first, so that a pile freezes from below.
void Freezer::freezeOneByOne()
{
    findPlaces();
    for (const std::uint32_t row : sleepy_)
    {
        if (running_.isGone(row))
        {
            continue;
        }
        if (stale_[row] != 0)
        {
            if (!isOverdue(row))
            {
                continue; // its turn comes in the next window
            }
            findPlace(row);
        }
        if (carriedAt_[row])
        {
            tryFreeze(row);
        }
    }
}

// All threads look for places, among the spheres that are at rest before any of these freezes. A
// sphere waits for the next window when another one has frozen beside it since. An overdue sphere
// may go far, where it is not told of others, so its place is found in its turn.
void Freezer::findPlaces()
{
    const auto find = [this](std::size_t i)
    {
        const std::uint32_t row = sleepy_[i];
        stale_[row] = isOverdue(row) ? 1 : 0;
        if (stale_[row] == 0 && !running_.isGone(row))
        {
            findPlace(row);
        }
    };
    threads_.forEach(sleepy_.size(), find);
}

// Where the runner would be frozen. One that is overdue is frozen wherever it gets.
void Freezer::findPlace(std::uint32_t row)
{
    const bool tooOld = isOverdue(row);
    const double radius = running_.radius[row];
    // In a pile one that does not give way would stir all the others.
    const bool patient = isPile() || watch_[row].stillWindows < kPatience;
    if (!patient || tooOld)
    {
        solver_.velocities().stopYielding(row);
    }
    stale_[row] = 0;
    carriedAt_[row].reset();
    if (flight_.isHeld(row))
    {
        carriedAt_[row] = running_.position[row];
        return;
    }
    flight_.findContacts(row, kSleepyGap * radius);
    Eigen::Vector3d place = running_.position[row];
    if (!tooOld && !isCarried(world_.pull.direction(place), flight_.normals(row), kMostlyUncarried))
    {
        return;
    }
    const double farthest =
        tooOld ? std::numeric_limits<double>::infinity() : kLongestSettling * radius;
    if (dropAndRoll_.settle(place, radius, flight_.around(row), farthest) || tooOld)
    {
        carriedAt_[row] = place;
    }
}

// Leaves the runner running when others are in the way.
void Freezer::tryFreeze(std::uint32_t row, bool insist)
{
    const PlacedSphere resting = {*carriedAt_[row], running_.radius[row]};
    const bool tooOld = isOverdue(row);
    const bool mayGoFar = insist || tooOld || watch_[row].stillWindows > kBlocked;
    const bool room = resolver_.moveAside(row, resting, mayGoFar ? kFarRoom : kNearRoom);
    if (!room && !insist && !tooOld && watch_[row].stillWindows <= kBlockedForGood)
    {
        return;
    }
    const std::uint32_t atRest = world_.spheres.freeze(running_.id[row], resting.place);
    if (!room)
    {
        resolver_.evict();
    }
    for (const std::uint32_t moved : resolver_.overlapped())
    {
        stale_[moved] = 1;
    }
    world_.counts.overdue += tooOld ? 1 : 0;
    frozen_.push_back({atRest, watch_[row].age, tooOld, insist});
    // Its id may have changed: one that was withdrawn has left its own to the last sphere.
    release_->close(resting.place, resting.radius);
    tell(resting.place, resting.radius);
}

// Of those that have frozen together, some may have been moved aside by others, or have failed to
// freeze, and what they carried runs again. It is as old as it was, so that it will not do so for
// ever.
void Freezer::wakeUncarried()
{
    const auto isTogether = [](const Frozen& one) { return one.together; };
    if (std::none_of(frozen_.begin(), frozen_.end(), isTogether))
    {
        return;
    }
    std::map<std::uint32_t, double> ages; // by id
    std::vector<std::uint32_t> ids;
    for (const Frozen& one : frozen_)
    {
        if (!one.tooOld)
        {
            ids.push_back(world_.spheres.resting().id(one.atRest));
            ages.emplace(ids.back(), one.age);
        }
    }
    const std::size_t before = running_.size();
    support_.wakeUncarried(
        std::move(ids), [&](std::uint32_t id) { return ages.contains(id); },
        [&](std::uint32_t id)
        {
            world_.spheres.wake(id);
            watch_[world_.spheres.row(id)].age = ages.at(id);
        });
    if (running_.size() > before)
    {
        flight_.forgetNeighbours();
    }
}

void Freezer::tell(const Eigen::Vector3d& place, double radius)
{
    // A neighbourhood was made within the skin of where its runner is now.
    grid_.forEachNear(place, 1 + radius + 2 * NeighbourList::kSkin,
                      [&](std::uint32_t row)
                      {
                          if (flight_.around(row).add(place, radius))
                          {
                              stale_[row] = 1;
                              watch_[row].age = 0; // what carries it has only now come to rest
                          }
                      });
}

} // namespace frostfill
