// SPDX-License-Identifier: MIT
// How FastEngine freezes: each sphere by itself, as soon as it is calm and carried by what is at
// rest. At freezing it is taken to the nearest place below at which its contacts carry it, so it
// neither overlaps anything nor hangs in the air.

#include "simulation/contact/contact_cone.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/engine/fast_engine.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

// Here r is the radius of the sphere that the sentence is about.
constexpr double kStill = 0.03;           // a calm sphere moves less than this in a window [r]
constexpr double kContactGap = 0.01;      // below which a contact carries, for the first look [r]
constexpr double kMostlyCarried = 0.5;    // weight that may be missing at that first look
constexpr double kLongestSettling = 0.15; // a sphere that is frozen comes down by less [r]
constexpr double kNearRoom = 0.1; // that a runner may be moved out of a freezing one's place [r]
constexpr double kFarRoom = 1;    // the same for one that others have been blocking for long [r]
constexpr std::uint32_t kStillInPile =
    4;                                 // calm windows after which those in a pile freeze together
constexpr std::uint32_t kPatience = 8; // calm windows after which a sphere stops giving way
constexpr std::uint32_t kPatienceInPile = 64; // the same where many carry each other
constexpr std::uint32_t kBlocked = 24;        // after which others are moved far out of its place
constexpr std::uint32_t kBlockedForGood = 72; // and after which they have to appear elsewhere
// In a narrow wedge between a wall and a sphere each move gains little. A sphere that cannot be
// moved out of one blocks the one below it, and all that lie on them, until they are overdue.
constexpr int kMovesOutOfWedge = 1000;

} // namespace

// The lowest first, so that a pile freezes from below. Places are looked for on all threads at once
// among what was at rest before; one beside which something has come to rest since waits for the
// next window.
void FastEngine::freezeSleepy()
{
    findSleepy();
    if (world_.scene.freezing.bySet && waitForSet())
    {
        return;
    }
    frozen_.assign(running_, false);
    grid_.rebuild({runners_.data(), running_});
    if (isPile())
    {
        freezeTogether(world_.scene.freezing.bySet ? 1 : kStillInPile);
    }
    threads_.forEach(sleepy_.size(),
                     [&](std::size_t i)
                     {
                         Runner& runner = runners_[sleepy_[i]];
                         // One that is overdue may go far, where it would not be told of others.
                         runner.stale = runner.age > ageLimit_;
                         if (!runner.stale && !frozen_[sleepy_[i]])
                         {
                             findPlace(runner);
                         }
                     });
    for (const std::uint32_t k : sleepy_)
    {
        if (frozen_[k])
        {
            continue;
        }
        if (runners_[k].stale)
        {
            if (runners_[k].age <= ageLimit_)
            {
                continue; // its turn comes in the next window
            }
            findPlace(runners_[k]);
        }
        frozen_[k] = runners_[k].carriedAt && tryFreeze(k);
    }
    forgetFrozen();
}

void FastEngine::findSleepy()
{
    sleepy_.clear();
    for (std::uint32_t k = 0; k < running_; ++k)
    {
        Runner& runner = runners_[k];
        const double still = kStill * runner.radius;
        const bool calm = (runner.position - runner.watched).squaredNorm() < still * still;
        runner.watched = runner.position;
        runner.stillWindows = calm ? runner.stillWindows + 1 : 0;
        if (runner.stillWindows > 0 || runner.age > ageLimit_)
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

// Where the runner would be frozen. One that is overdue is frozen wherever it gets.
void FastEngine::findPlace(Runner& runner) const
{
    const bool tooOld = runner.age > ageLimit_;
    // In a pile one that does not give way would stir all the others.
    const bool patient = runner.stillWindows < (isPile() ? kPatienceInPile : kPatience);
    runner.yields = runner.yields && patient && !tooOld;
    runner.stale = false;
    runner.carriedAt.reset();
    flight_.findContacts(runner, kContactGap * runner.radius);
    const double missing =
        projectToFree(world_.pull.direction(runner.position), runner.normals).norm();
    if (missing > kMostlyCarried && !tooOld)
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
bool FastEngine::tryFreeze(std::uint32_t index, bool insist)
{
    Runner& runner = runners_[index];
    const Eigen::Vector3d place = *runner.carriedAt;
    const bool tooOld = runner.age > ageLimit_;
    const bool blocked = insist || tooOld || runner.stillWindows > kBlocked;
    findOverlapped(index, place);
    const bool room = makeRoom({place, runner.radius}, blocked ? kFarRoom : kNearRoom);
    if (!room && !insist && !tooOld && runner.stillWindows <= kBlockedForGood)
    {
        return false;
    }
    world_.spheres.setPosition(runner.id, place);
    world_.freeze(runner.id);
    if (!room)
    {
        evictOverlapped();
    }
    world_.overdue += tooOld ? 1 : 0;
    falls_.insert(place);
    release_->close(place, runner.radius);
    tellOthers(place, runner.radius);
    if (discard_)
    {
        discard_->addResting(runner.id);
    }
    return true;
}

// Runners that a sphere at rest at this place would overlap.
void FastEngine::findOverlapped(std::uint32_t index, const Eigen::Vector3d& place)
{
    overlapped_.clear();
    const double radius = runners_[index].radius;
    grid_.forEachNear(place, radius + 1,
                      [&](std::uint32_t k, const Eigen::Vector3d& p, double radiusThere)
                      {
                          const double contact = radiusThere + radius;
                          if (k != index && !frozen_[k] &&
                              (p - place).squaredNorm() < contact * contact)
                          {
                              overlapped_.push_back(k);
                          }
                      });
    std::sort(overlapped_.begin(), overlapped_.end());
}

// Moves every runner that a sphere which is to come to rest overlaps to a clear place nearby.
// Returns false, and moves none, when one of them cannot be moved.
bool FastEngine::makeRoom(const PlacedSphere& resting, double farthest)
{
    moved_.clear();
    for (const std::uint32_t k : overlapped_)
    {
        moved_.push_back(runners_[k].position);
        if (!depenetrate(world_, resting, moved_.back(), runners_[k].radius,
                         farthest * runners_[k].radius, kMovesOutOfWedge))
        {
            return false;
        }
    }
    for (std::size_t i = 0; i < overlapped_.size(); ++i)
    {
        put(overlapped_[i], moved_[i]);
    }
    return true;
}

void FastEngine::put(std::uint32_t index, const Eigen::Vector3d& place)
{
    runners_[index].position = place;
    runners_[index].around.invalidate(); // what comes to rest is told where it is now
    runners_[index].stale = true;
    grid_.move(index, place);
}

// The last resort, for a sphere that rests where others are and that they will not make room for:
// these appear again elsewhere, or are withdrawn when the object is full.
void FastEngine::evictOverlapped()
{
    const auto suits = [this](const Eigen::Vector3d& place, double radius)
    { return clearOfRunners(place, radius); };
    for (const std::uint32_t k : overlapped_)
    {
        Runner& other = runners_[k];
        Eigen::Vector3d clear = other.position;
        if (depenetrate(world_, clear, other.radius, kFarRoom * other.radius))
        {
            put(k, clear);
        }
        else if (const auto elsewhere = release_->find(other.radius, suits))
        {
            other.restart(other.id, *elsewhere, other.radius);
            grid_.move(k, *elsewhere);
        }
        else
        {
            frozen_[k] = true; // not to be looked at any more
            withdraw(other);
        }
    }
}

void FastEngine::withdraw(Runner& runner)
{
    const std::uint32_t id = std::exchange(runner.id, Runner::kNobody);
    const std::uint32_t renumbered = world_.withdraw(id);
    if (discard_)
    {
        discard_->renumber(renumbered, id);
    }
    for (std::size_t k = 0; k < running_; ++k)
    {
        if (runners_[k].id == renumbered)
        {
            runners_[k].id = id;
        }
    }
}

void FastEngine::tellOthers(const Eigen::Vector3d& place, double radius)
{
    // A neighbourhood was made within the skin of where its runner is now.
    grid_.forEachNear(place, 1 + radius + 2 * NeighbourList::kSkin,
                      [&](std::uint32_t k, const Eigen::Vector3d&, double)
                      {
                          if (runners_[k].around.add(place, radius))
                          {
                              runners_[k].stale = true;
                              runners_[k].age = 0; // what carries it has only now come to rest
                          }
                      });
}

// The last ones take the places of the frozen ones, whose memory is kept for spheres to come.
void FastEngine::forgetFrozen()
{
    for (std::size_t k = running_; k-- > 0;)
    {
        if (frozen_[k])
        {
            --running_;
            if (k != running_)
            {
                std::swap(runners_[k], runners_[running_]);
            }
        }
    }
    world_.forgetFrozen();
}

} // namespace frostfill
