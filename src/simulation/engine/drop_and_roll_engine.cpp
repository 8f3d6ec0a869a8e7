// SPDX-License-Identifier: MIT
#include "simulation/engine/drop_and_roll_engine.hpp"

#include "base/timers.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/engine/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace frostfill
{

ReleaseQuery queryOfRest(const DropAndRoll& dropAndRoll, std::size_t threads)
{
    ReleaseQuery query;
    query.suits = [](const Eigen::Vector3d&, double) { return true; };
    query.ahead = kAheadOfThread * threads;
    query.prepare = [&dropAndRoll](Eigen::Vector3d& place, double radius, Eigen::AlignedBox3d& seen)
    {
        thread_local NeighbourList around; // keeps its memory
        around.invalidate();
        return dropAndRoll.settle(place, radius, around, std::numeric_limits<double>::infinity(),
                                  &seen);
    };
    return query;
}

DropAndRollEngine::DropAndRollEngine(World& world)
    : world_(world), threads_(world.scene.threads),
      release_(makeRelease(world, world.height, threads_)), dropAndRoll_(world),
      query_(queryOfRest(dropAndRoll_, threads_.concurrency()))
{
    query_.stop = &world.stop;
    const SphereSettings& spheres = world.scene.spheres;
    setSize_ = std::max<std::size_t>(groupSize(world) * spheres.groupsPerSet,
                                     expectedCount(world) / kMaxSets);
    stepSize_ = std::max<std::size_t>(1, expectedCount(world) / kMaxSets);
    // Nothing moves in time. A set counts as one unit, so that pictures show the object fill up.
    world.clock.dt = static_cast<double>(stepSize_) / static_cast<double>(setSize_);
}

bool DropAndRollEngine::step()
{
    if (world_.clock.finished)
    {
        return false;
    }
    const std::size_t wanted = wantedOfSet(world_, std::min(stepSize_, setSize_ - inSet_));
    if (inSet_ == 0)
    {
        clock_.open(world_, 0);
    }
    std::size_t placed = 0;
    bool noPlace = false;
    {
        const StageTimer timer(world_.counts.times, Stage::motion);
        while (placed < wanted && !world_.stop.isAsked() && placeOne())
        {
            ++placed;
        }
        inSet_ += placed;
        world_.counts.sets.back().spheres = inSet_;
        noPlace = placed < wanted && !world_.stop.isAsked();
    }
    ++world_.clock.steps;
    if (noPlace)
    {
        endForWantOfPlaces(world_, *release_);
    }
    world_.clock.finished = noPlace || wantedOfSet(world_, 1) == 0;
    world_.clock.time += static_cast<double>(placed) / static_cast<double>(setSize_);
    if (world_.clock.finished || inSet_ == setSize_ || world_.stop.isAsked())
    {
        clock_.close(world_);
        inSet_ = 0;
    }
    return true;
}

// Returns false when no place is left.
bool DropAndRollEngine::placeOne()
{
    const auto found = release_->next(query_);
    if (found)
    {
        rest(found->place, found->radius);
    }
    return found.has_value();
}

void DropAndRollEngine::rest(const Eigen::Vector3d& place, double radius)
{
    const auto group = static_cast<std::uint32_t>(world_.spheres.size() / groupSize(world_));
    world_.spheres.addResting(place, radius, group);
    release_->close(place, radius);
}

void DropAndRollEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        Eigen::Vector3d place = one.place;
        if (!depenetrate(world_, place, one.radius, kFarRelease) ||
            !dropAndRoll_.settle(place, one.radius))
        {
            refuseOverlap(world_, one);
        }
        rest(place, one.radius);
    }
}

} // namespace frostfill
