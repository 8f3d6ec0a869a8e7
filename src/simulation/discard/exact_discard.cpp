// SPDX-License-Identifier: MIT
#include "simulation/discard/exact_discard.hpp"

#include "simulation/discard/tolerances.hpp"

#include <algorithm>

namespace frostfill
{
// Small spheres of a size curve pass between large ones and get everywhere: a map of where would
// cost more than all else, for nothing.
ExactDiscard::ExactDiscard(World& world, Threads& threads) : world_(world), threads_(threads)
{
    if (!world.radii.curve() || world.radii.smallest() > kPassesBetween)
    {
        build();
    }
}

void ExactDiscard::build()
{
    const ReachMap::Radii radii = {world_.radii.smallest(), world_.radii.largest()};
    for (; violations_ < kReachMargins.size(); ++violations_)
    {
        ReachMap::Margins margins = kReachMargins[violations_];
        margins.overlap *= radii.smallest;
        margins.step *= radii.smallest;
        map_ = std::make_unique<ReachMap>(world_.surface, world_.inside, radii, margins,
                                          ReachMap::Resolution{kReachVoxel});
        polygons_ = std::make_unique<PolygonWitnesses>(world_.surface);
        // The margin is widest for the smallest contact.
        const double overlap = radii.smallest - map_->exclusion(radii.smallest);
        clear_ = std::make_unique<ClearSearch>(world_.spheres.resting(), world_.surface,
                                               world_.triangles, radii.smallest, overlap);
        clear_->halve(closer_ ? kHalvingsWhenNearlyFull : kHalvings);
        held_ = std::make_unique<HeldCubes>(map_->layout(), *clear_);
        for (const Kept& kept : kept_)
        {
            map_->addResting(world_.spheres.position(kept.id), world_.spheres.radius(kept.id));
        }
        if (map_->flood(centres_))
        {
            return;
        }
    }
    map_.reset();
}

void ExactDiscard::addResting(std::uint32_t id)
{
    pending_.push_back(id);
}

void ExactDiscard::takeBack(std::uint32_t id)
{
    std::erase(pending_, id);
}

void ExactDiscard::renumber(std::uint32_t from, std::uint32_t to)
{
    std::replace(pending_.begin(), pending_.end(), from, to);
    const auto same = [&](const Kept& kept) { return kept.id == from; };
    if (const auto found = std::find_if(kept_.begin(), kept_.end(), same); found != kept_.end())
    {
        found->id = to;
    }
}

// A picture in which more than that is discarded at once seems to jump.
std::size_t ExactDiscard::batch() const
{
    return std::max<std::size_t>(1, expectedCount(world_) / kUpdates);
}

bool ExactDiscard::afterStep()
{
    if (!map_ || !map_->active())
    {
        return false;
    }
    const std::span<const Eigen::Vector3d> running = world_.spheres.running().position.all();
    const auto astray = [this](const Eigen::Vector3d& p) { return !map_->contains(p); };
    const bool trip = std::any_of(running.begin(), running.end(), astray);
    // The newest one waits: it is the last one if nothing follows; see finish.
    if (!trip && pending_.size() <= batch())
    {
        return false;
    }
    centres_.assign(running.begin(), running.end());
    const std::size_t before = violations_;
    trip ? restoreAll() : updateWithoutTheNewest();
    return violations_ != before;
}

// Cubes of which the coarse search said that they may hold a place are then asked once more.
void ExactDiscard::refineNearTheEnd()
{
    const bool untilFull = world_.targetCount == 0;
    const auto resting = static_cast<double>(world_.spheres.discardedCount() + kept_.size());
    if (!closer_ && untilFull && resting > kNearlyFull * static_cast<double>(expectedCount(world_)))
    {
        closer_ = true;
        clear_->halve(kHalvingsWhenNearlyFull);
        held_->forgetAll();
    }
}

void ExactDiscard::updateWithoutTheNewest()
{
    refineNearTheEnd();
    const std::size_t before = violations_;
    const std::uint32_t newest = pending_.back();
    pending_.pop_back();
    clear_->ignore(world_.spheres.row(newest));
    update(centres_);
    if (violations_ == before)
    {
        pending_.push_back(newest);
    }
}

void ExactDiscard::finish(bool full)
{
    if (!map_ || !map_->active())
    {
        return;
    }
    centres_.clear();
    clear_->ignore(ClearSearch::kNone);
    if (full && !pending_.empty())
    {
        // No place is left, so only the last sphere could touch anything.
        const std::uint32_t last = pending_.back();
        pending_.pop_back();
        centres_.push_back(world_.spheres.position(last));
        clear_->ignore(world_.spheres.row(last));
        map_->withdrawSeeds();
    }
    update(centres_);
    if (map_)
    {
        dropSpheres(kept_.size());
        dropPolygons();
    }
}

void ExactDiscard::update(std::span<const Eigen::Vector3d> running)
{
    const std::size_t before = kept_.size();
    addToMap(pending_);
    for (const std::uint32_t id : pending_)
    {
        kept_.push_back({id});
    }
    pending_.clear();
    if (!map_->update(running))
    {
        restoreAll();
        return;
    }
    // Spheres that have only just come to rest are mostly at the surface of the pile.
    dropSpheres(before);
    dropPolygons();
}

// Places that the spheres may take are no longer known to be there.
void ExactDiscard::addToMap(std::span<const std::uint32_t> ids)
{
    std::vector<Ball> balls;
    balls.reserve(ids.size());
    for (const std::uint32_t id : ids)
    {
        balls.push_back(world_.spheres.resting()[world_.spheres.row(id)]);
    }
    const BallSlabs slabs(map_->layout().frame, balls, map_->reachOf(world_.radii.largest()));
    map_->addResting(slabs, threads_);
    held_->forgetNear(slabs, world_.radii.smallest(), threads_);
}

// Looks at the oldest ones of those that are kept.
void ExactDiscard::dropSpheres(std::size_t count)
{
    droppable_.assign(count, 0);
    threads_.forEach(count,
                     [&](std::size_t i) { droppable_[i] = sphereDroppable(kept_[i]) ? 1 : 0; });
    closeEmptyCubes();
    std::size_t left = 0;
    for (std::size_t i = 0; i < kept_.size(); ++i)
    {
        if (i < count && droppable_[i] != 0)
        {
            world_.spheres.discard(kept_[i].id);
            continue;
        }
        kept_[left++] = kept_[i];
    }
    kept_.resize(left);
}

void ExactDiscard::dropPolygons()
{
    const auto mayHold = [this](int x, int y, int z) { return held_->mayHold(x, y, z); };
    const auto isHeld = [this](CubeNumber cube) { return held_->isHeld(cube); };
    const std::vector<std::uint32_t> untouchable =
        polygons_->takeUntouchable(*map_, threads_, mayHold, isHeld);
    closeEmptyCubes();
    for (const std::uint32_t polygon : untouchable)
    {
        world_.discardPolygon(polygon);
    }
}

bool ExactDiscard::sphereDroppable(Kept& kept)
{
    const auto mayHold = [this](int x, int y, int z) { return held_->mayHold(x, y, z); };
    const auto isHeld = [this](CubeNumber cube) { return held_->isHeld(cube); };
    return !map_->isReached(kept.witness, mayHold, isHeld) &&
           map_->sphereDroppable(
               world_.spheres.position(kept.id), world_.spheres.radius(kept.id), kept.cursor,
               [&](int x, int y, int z) { return holdsPlace(x, y, z, kept.witness); });
}

// Whether a reached cube may hold a free place: then it is a witness.
bool ExactDiscard::holdsPlace(int x, int y, int z, CubeNumber& witness)
{
    if (!held_->mayHold(x, y, z))
    {
        return false;
    }
    witness = numberOf(map_->layout().at(x, y, z));
    return true;
}

void ExactDiscard::closeEmptyCubes()
{
    held_->drainEmpty([this](VoxelWord cubes) { map_->closeCubes(cubes); });
}

// A guard has tripped: some centre is where the map says that none can be. Everything comes back,
// and the map is made anew with wider margins.
void ExactDiscard::restoreAll()
{
    world_.restoreDiscarded();
    kept_.clear();
    pending_.clear();
    for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
    {
        if (world_.spheres.state(id) == SphereState::frozen)
        {
            kept_.push_back({id});
        }
    }
    ++violations_;
    build();
}

} // namespace frostfill
