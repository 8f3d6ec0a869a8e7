// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezer.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace frostfill
{

Freezer::Freezer(World& world, Runners& runners, RestFollowers& followers, const FreeFlight& flight,
                 PositionSolver& solver, Threads& threads, double ageLimit)
    : world_(world), runners_(runners), followers_(followers), flight_(flight), solver_(solver),
      threads_(threads), dropAndRoll_(world, followers.falls), island_(flight, threads),
      room_(world, runners, followers), ageLimit_(ageLimit), layer_(spheresInLayer(world))
{
}

void Freezer::freeze(SetKeeper& sets)
{
    findSleepy();
    sets.endWindow(runners_.all(), sleepy_);
    if (sleepy_.empty())
    {
        return;
    }
    runners_.startFreezing();
    if (isPile())
    {
        freezeTogether(sets.keepsSets() ? 1 : kStillInPile);
    }
    freezeOneByOne();
    runners_.removeAsleep();
    world_.forgetFrozen();
    if (followers_.discard)
    {
        followers_.discard->afterFreezing();
    }
}

void Freezer::findSleepy()
{
    sleepy_.clear();
    for (std::uint32_t k = 0; k < runners_.count(); ++k)
    {
        Runner& runner = runners_[k];
        const double still = kStill * runner.radius;
        const bool calm = (runner.position - runner.watched).squaredNorm() < still * still;
        runner.watched = runner.position;
        runner.stillWindows = calm ? runner.stillWindows + 1 : 0;
        if (runner.stillWindows > 0 || isOverdue(runner))
        {
            sleepy_.push_back(k);
        }
    }
    const Eigen::Vector3d down = world_.pull.direction(Eigen::Vector3d::Zero());
    std::sort(sleepy_.begin(), sleepy_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              {
                  const double ya = -runners_[a].position.dot(down);
                  const double yb = -runners_[b].position.dot(down);
                  return ya < yb || (ya == yb && a < b);
              });
}

// Calm spheres that lie on each other as well as on what is at rest, as in a pile that has come to
// rest as a whole. They are frozen where they are, once their overlaps are taken apart.
void Freezer::freezeTogether(std::uint32_t stillWindows)
{
    const std::span<Runner> runners = runners_.all();
    for (Runner& runner : runners)
    {
        runner.member = false;
    }
    together_.clear();
    for (const std::uint32_t k : sleepy_)
    {
        if (runners[k].stillWindows >= stillWindows)
        {
            together_.push_back(k);
            runners[k].member = true;
        }
    }
    island_.keep(runners, together_);
    if (together_.empty())
    {
        return;
    }
    solver_.separate(runners, together_);
    runners_.rebuildGrid();
    island_.keep(runners, together_);
    for (const std::uint32_t k : together_)
    {
        // Those before may have made this one give way, or have failed to freeze.
        if (!runners_.isAsleep(k) && island_.carry(runners, runners[k]))
        {
            runners[k].carriedAt = runners[k].position;
            if (tryFreeze(k, true))
            {
                runners_.putToSleep(k);
            }
        }
        runners[k].member = false; // at rest or given up
    }
}

// The lowest first, so that a pile freezes from below. Places are looked for on all threads at once
// among what was at rest before; one beside which something has come to rest since waits for the
// next window.
void Freezer::freezeOneByOne()
{
    threads_.forEach(sleepy_.size(),
                     [&](std::size_t i)
                     {
                         Runner& runner = runners_[sleepy_[i]];
                         // One that is overdue may go far, where it would not be told of others.
                         runner.stale = isOverdue(runner);
                         if (!runner.stale && !runners_.isAsleep(sleepy_[i]))
                         {
                             findPlace(runner);
                         }
                     });
    for (const std::uint32_t k : sleepy_)
    {
        Runner& runner = runners_[k];
        if (runners_.isAsleep(k))
        {
            continue;
        }
        if (runner.stale)
        {
            if (!isOverdue(runner))
            {
                continue; // its turn comes in the next window
            }
            findPlace(runner);
        }
        if (runner.carriedAt && tryFreeze(k))
        {
            runners_.putToSleep(k);
        }
    }
}

// Where the runner would be frozen. One that is overdue is frozen wherever it gets.
void Freezer::findPlace(Runner& runner) const
{
    const bool tooOld = isOverdue(runner);
    // In a pile one that does not give way would stir all the others.
    const bool patient = runner.stillWindows < (isPile() ? kPatienceInPile : kPatience);
    runner.yields = runner.yields && patient && !tooOld;
    runner.stale = false;
    runner.carriedAt.reset();
    flight_.findContacts(runner, kSleepyGap * runner.radius);
    if (!tooOld &&
        !isCarried(world_.pull.direction(runner.position), runner.normals, kMostlyUncarried))
    {
        return;
    }
    Eigen::Vector3d place = runner.position;
    const double farthest =
        tooOld ? std::numeric_limits<double>::infinity() : kLongestSettling * runner.radius;
    if (dropAndRoll_.settle(place, runner.radius, runner.around, farthest) || tooOld)
    {
        runner.carriedAt = place;
    }
}

// Returns false, and leaves the runner running, when others are in the way.
bool Freezer::tryFreeze(std::uint32_t index, bool insist)
{
    Runner& runner = runners_[index];
    const Eigen::Vector3d place = *runner.carriedAt;
    const bool tooOld = isOverdue(runner);
    const bool blocked = insist || tooOld || runner.stillWindows > kBlocked;
    const bool room = room_.makeRoom(index, {place, runner.radius}, blocked ? kFarRoom : kNearRoom);
    if (!room && !insist && !tooOld && runner.stillWindows <= kBlockedForGood)
    {
        return false;
    }
    world_.spheres.setPosition(runner.id, place);
    world_.freeze(runner.id);
    if (!room)
    {
        room_.evict();
    }
    world_.overdue += tooOld ? 1 : 0;
    followers_.add(runner.id, place, runner.radius);
    runners_.tell(place, runner.radius);
    return true;
}

} // namespace frostfill
