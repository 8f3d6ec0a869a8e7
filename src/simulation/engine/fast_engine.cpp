// SPDX-License-Identifier: MIT
#include "simulation/engine/fast_engine.hpp"

#include "base/timers.hpp"
#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/engine/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Of spheres of different sizes: that of the mean volume.
double usualRadius(const World& world)
{
    return std::cbrt(world.radii.meanPower(3));
}

double timeStep(const World& world)
{
    if (world.scene.motion.dt)
    {
        const double longest = kSkipStep * std::sqrt(world.radii.smallest());
        const double asked = *world.scene.motion.dt / world.frame.time;
        return asked / std::ceil(asked / longest);
    }
    const bool quiet = world.scene.motion.mode == Motion::skip && !world.scene.move.any();
    const double step = quiet ? kSkipStep : kStep;
    const double ofSmallest = step * std::sqrt(world.radii.smallest());
    return quiet && world.radii.curve()
               ? std::min(kLongerForSizes * ofSmallest, step * std::sqrt(usualRadius(world)))
               : ofSmallest;
}

// The age at which a sphere is overdue: what one may take that falls through the object and bounces
// on its floor, with time to spare.
double ageLimit(const World& world)
{
    const double fall = std::sqrt(2 * world.height);
    const double e = std::min(world.scene.motion.restitution, kLiveliest);
    return world.scene.freezing.setTimeLimit + fall * std::max(kMinFalls, (1 + e) / (1 - e));
}

double releaseBand(const World& world)
{
    return world.scene.motion.mode == Motion::fall ? kTopBand : world.height;
}

// Where small spheres make steps shorter, the gap up to which two are a pair is as much smaller.
double pairMargin(const World& world)
{
    return world.radii.curve() ? kPairMargin * std::min(1.0, timeStep(world) / kLongestOfMargin)
                               : kPairMargin;
}

int sweeps(const World& world)
{
    const int asked = world.scene.motion.sweeps;
    return world.scene.move.any() ? std::max(kSweepsInAvalanche, asked) : asked;
}

} // namespace

FastEngine::FastEngine(World& world)
    : world_(world), running_(world.spheres.running()), threads_(world.scene.threads),
      grid_(world.spheres.resting().frame()),
      release_(makeRelease(world, releaseBand(world), threads_)),
      flight_(world, {.restitution = {world.scene.motion.restitution},
                      .rolling = RollingLaw::of(world.scene)}),
      dropAndRoll_(world), sets_(world, ageLimit(world)),
      solver_(running_, flight_, threads_,
              {.restitution = {world.scene.motion.restitution},
               .sweeps = sweeps(world),
               .stiff = !sets_.keepsSets(),
               .pairMargin = pairMargin(world)}),
      freezer_(world, grid_, release_, flight_, solver_, threads_, ageLimit(world)), waker_(world)
{
    world.clock.dt = timeStep(world);
    windowSteps_ = std::max(1u, static_cast<std::uint32_t>(std::lround(kWindow / world.clock.dt)));
}

bool FastEngine::step()
{
    if (world_.clock.finished)
    {
        return false;
    }
    releaseWhenDue();
    if (world_.stop.isAsked())
    {
        return true; // what found no place may only not have been looked for
    }
    if (!anythingMoves())
    {
        finish();
        return false;
    }
    advance();
    solve();
    freezeAndWake();
    return true;
}

void FastEngine::releaseWhenDue()
{
    if (waker_.isMoving() || !sets_.isDue(running_.size()))
    {
        return;
    }
    const StageTimer timer(world_.counts.times, Stage::releasing);
    sets_.endSearch(release(sets_.startSearch(running_.size())));
}

// Returns how many have found a place.
std::size_t FastEngine::release(std::size_t wanted)
{
    ReleaseQuery query;
    // Free flight is analytic: with Motion::skip a sphere appears where it would touch first.
    if (world_.scene.motion.mode == Motion::skip)
    {
        query.prepare = [this](Eigen::Vector3d& place, double radius, Eigen::AlignedBox3d& seen)
        {
            dropAndRoll_.drop(place, radius, &seen);
            return true;
        };
    }
    std::size_t found = 0;
    const auto appear = [&](const PlacedSphere& sphere)
    {
        world_.spheres.add(sphere.place, sphere.radius, sets_.groupOf(found++));
        energy_.reset();
    };
    return releaseAmong(running_, grid_, wanted, *release_, query, world_.stop, appear);
}

// Those that overlap are taken apart first, so that they do not start by flying apart.
void FastEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        Eigen::Vector3d place = one.place;
        if (!depenetrate(world_, place, one.radius, kFarRelease))
        {
            refuseOverlap(world_, one);
        }
        world_.spheres.add(place, one.radius, sets_.groupOf(0));
    }
    energy_.reset();
    sets_.placed(spheres.size());
    solver_.separate();
    freezer_.startWindow();
}

// When nothing runs any more, the object may still have to move.
bool FastEngine::anythingMoves()
{
    if (running_.size() > 0)
    {
        return true;
    }
    if (waker_.begin())
    {
        sets_.record().open(world_, 0);
    }
    return waker_.wakeAgain();
}

// Every runner flies by itself among what is at rest.
void FastEngine::advance()
{
    if (waker_.isMoving())
    {
        energy_.reset();
    }
    else if (!energy_)
    {
        energy_ = energyOf(running_, world_.frame.gravity);
    }
    // While the pull changes, nothing is due to be at rest.
    const bool ages = !waker_.pullChanges();
    const StageTimer timer(world_.counts.times, Stage::motion);
    threads_.forEach(running_.size(),
                     [&](std::size_t i)
                     {
                         const auto row = static_cast<std::uint32_t>(i);
                         flight_.advance(row, world_.clock.dt);
                         if (ages)
                         {
                             freezer_.age(row, world_.clock.dt);
                         }
                     });
}

// Then those that met are taken apart.
void FastEngine::solve()
{
    {
        const StageTimer timer(world_.counts.times, Stage::sphereSphere);
        solver_.resolve(world_.clock.dt);
        sets_.record().observe(1e3 * timer.seconds(), 0); // walls are met in flight
    }
    countTests();
    observeEnergy();
    ++world_.clock.steps;
    world_.clock.time += world_.clock.dt;
    if (waker_.isMoving())
    {
        world_.pull = world_.motion.pullAt(world_.clock.time - world_.motionStart);
    }
}

void FastEngine::freezeAndWake()
{
    if (++stepsInWindow_ < windowSteps_)
    {
        return;
    }
    const StageTimer timer(world_.counts.times, Stage::freezing);
    stepsInWindow_ = 0;
    energy_.reset();
    freezer_.freeze(sets_);
    if (waker_.stop())
    {
        // Places were closed for good where something has been at rest; now they are looked for
        // anew, for spheres that find no room where they are.
        release_ = makeRelease(world_, -1, threads_);
    }
    if (waker_.wakeWhenDue())
    {
        flight_.forgetNeighbours();
        solver_.velocities().letAllYield();
    }
}

void FastEngine::finish()
{
    endForWantOfPlaces(world_, *release_);
    world_.clock.finished = true;
    sets_.record().close(world_);
}

void FastEngine::countTests()
{
    std::uint64_t pairs = 0;
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        const NeighbourList& around = flight_.around(row);
        world_.counts.operations.runningFrozenTests += around.spheres().size();
        world_.counts.operations.spherePolygonTests += around.trianglesTested();
        pairs += solver_.pairs().nearby(row).size();
    }
    world_.counts.operations.runningRunningTests += pairs / 2;
}

// A moving object does work on the spheres, which is not counted.
void FastEngine::observeEnergy()
{
    if (!energy_)
    {
        return;
    }
    double mass = 0;
    for (const double radius : running_.radius.all())
    {
        mass += massOf(radius);
    }
    const double after = energyOf(running_, world_.frame.gravity);
    world_.counts.energy.enter(*energy_, after, mass * world_.height);
    energy_ = after;
}

} // namespace frostfill
