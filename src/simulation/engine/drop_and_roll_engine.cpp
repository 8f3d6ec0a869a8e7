// SPDX-License-Identifier: MIT
#include "simulation/engine/drop_and_roll_engine.hpp"

#include "base/stage_timer.hpp"
#include "simulation/contact/depenetration.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// A run is recorded as at most so many sets.
constexpr std::size_t kMostSets = 200;
/// Nothing moves in time here; a set counts as this, so that frames show the object fill up.
constexpr double kTimeOfSet = 1; // [sqrt(r/g)]
/// A sphere that is released in a wall is moved by less. [r]
constexpr double kFarRelease = 4;

} // namespace

DropAndRollEngine::DropAndRollEngine(World& world)
    : world_(world), threads_(world.scene.threads), falls_(world.resting.frame(), world.triangles),
      release_(world, world.height, threads_), dropAndRoll_(world, falls_)
{
    const SphereSettings& spheres = world.scene.spheres;
    if (world.scene.discard.rule == DiscardRule::exact)
    {
        const StageTimer timer(world.times, Stage::discarding);
        discard_ = std::make_unique<ExactDiscard>(world);
    }
    world.dt = kTimeOfSet;
    setSize_ = std::max<std::size_t>(groupSize(world) * spheres.groupsPerSet,
                                     expectedCount(world) / kMostSets);
    if (!release_.any())
    {
        refuseTooLarge(world);
    }
}

bool DropAndRollEngine::step()
{
    if (world_.finished)
    {
        return false;
    }
    std::size_t wanted = setSize_;
    if (world_.targetCount > 0)
    {
        wanted = std::min(wanted, world_.targetCount - world_.spheres.size());
    }
    clock_.open(world_, 0);
    {
        const StageTimer timer(world_.times, Stage::motion);
        std::size_t placed = 0;
        while (placed < wanted && placeOne())
        {
            ++placed;
        }
        world_.sets.back().spheres = placed;
        world_.full = placed < wanted;
    }
    ++world_.steps;
    world_.finished = world_.full || world_.spheres.size() == world_.targetCount;
    if (discard_)
    {
        const StageTimer timer(world_.times, Stage::discarding);
        world_.finished ? discard_->finish(world_.full) : discard_->afterStep({});
    }
    world_.time += world_.dt;
    clock_.close(world_);
    return true;
}

// Returns false when no place is left.
bool DropAndRollEngine::placeOne()
{
    const auto anywhere = [](const Eigen::Vector3d&, double) { return true; };
    while (auto found = release_.find(anywhere))
    {
        if (settle(found->place, found->radius))
        {
            return true;
        }
        release_.giveUp();
    }
    return false;
}

// Takes a sphere down from a clear place. Returns false when nothing there carries it.
bool DropAndRollEngine::settle(Eigen::Vector3d place, double radius)
{
    if (!dropAndRoll_.settle(place, radius))
    {
        return false;
    }
    const auto group = static_cast<std::uint32_t>(world_.spheres.size() / groupSize(world_));
    world_.freeze(world_.spheres.add(place, radius, group)); // never runs
    falls_.insert(place);
    release_.close(place, radius);
    if (discard_)
    {
        discard_->addResting(static_cast<std::uint32_t>(world_.spheres.size() - 1));
    }
    return true;
}

void DropAndRollEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        Eigen::Vector3d place = one.place;
        if (!depenetrate(world_, place, one.radius, kFarRelease) || !settle(place, one.radius))
        {
            refuseCrowdedPlace(world_, one);
        }
    }
}

} // namespace frostfill
