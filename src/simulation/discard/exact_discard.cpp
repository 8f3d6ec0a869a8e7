// SPDX-License-Identifier: MIT
#include "simulation/discard/exact_discard.hpp"

#include "simulation/discard/tolerances.hpp"

#include <algorithm>

namespace frostfill
{
ExactDiscard::ExactDiscard(World& world) : world_(world)
{
    build();
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
        holding_.assign(map_->layout().words, 0);
        // The margin is widest for the smallest contact.
        const double overlap = radii.smallest - map_->exclusion(radii.smallest);
        clear_ = std::make_unique<ClearSearch>(world_.resting, world_.surface, world_.triangles,
                                               radii.smallest, overlap);
        for (const Kept& kept : kept_)
        {
            map_->addResting(world_.spheres.position(kept.id), world_.spheres.radius[kept.id]);
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

void ExactDiscard::renumber(std::uint32_t from, std::uint32_t to)
{
    std::replace(pending_.begin(), pending_.end(), from, to);
    const auto same = [&](const Kept& kept) { return kept.id == from; };
    if (const auto found = std::find_if(kept_.begin(), kept_.end(), same); found != kept_.end())
    {
        found->id = to;
    }
}

void ExactDiscard::afterStep(std::span<Runner> runners)
{
    if (!map_ || !map_->active())
    {
        return;
    }
    const auto astray = [this](const Runner& runner) { return !map_->contains(runner.position); };
    const bool trip = std::any_of(runners.begin(), runners.end(), astray);
    const auto batch = std::max(
        kSmallestBatch, static_cast<std::size_t>(kBatch * static_cast<double>(kept_.size())));
    if (!trip && pending_.size() < batch)
    {
        return;
    }
    centres_.clear();
    for (const Runner& runner : runners)
    {
        centres_.push_back(runner.position);
    }
    if (!trip)
    {
        const std::size_t before = violations_;
        update(centres_);
        if (violations_ == before)
        {
            return;
        }
    }
    else
    {
        restoreAll();
    }
    for (Runner& runner : runners)
    {
        runner.around.invalidate();
    }
}

void ExactDiscard::finish(bool full)
{
    if (!map_ || !map_->active())
    {
        return;
    }
    centres_.clear();
    if (full && !pending_.empty())
    {
        // No place is left, so only the last sphere could touch anything.
        const std::uint32_t last = pending_.back();
        pending_.pop_back();
        centres_.push_back(world_.spheres.position(last));
        clear_->ignore(last);
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
    for (const std::uint32_t id : pending_)
    {
        map_->addResting(world_.spheres.position(id), world_.spheres.radius[id]);
        kept_.push_back({id, 0});
    }
    restedSincePolygons_ += pending_.size();
    pending_.clear();
    if (!map_->update(running))
    {
        restoreAll();
        return;
    }
    holding_.assign(map_->layout().words, 0);
    // Spheres that have only just come to rest are mostly at the surface of the pile.
    dropSpheres(before);
    const std::size_t active = world_.polygons.size() - world_.discardedPolygons;
    if (restedSincePolygons_ >=
        std::max(expectedCount(world_) / kPolygonRounds,
                 static_cast<std::size_t>(kPolygonBatch * static_cast<double>(active))))
    {
        dropPolygons();
    }
}

// Looks at the oldest ones of those that are kept.
void ExactDiscard::dropSpheres(std::size_t count)
{
    const auto end = kept_.begin() + static_cast<std::ptrdiff_t>(count);
    const auto dropped = std::remove_if(kept_.begin(), end,
                                        [this](Kept& kept)
                                        {
                                            const bool droppable = sphereDroppable(kept);
                                            if (droppable)
                                            {
                                                world_.discard(kept.id);
                                            }
                                            return droppable;
                                        });
    kept_.erase(dropped, end);
}

void ExactDiscard::dropPolygons()
{
    restedSincePolygons_ = 0;
    for (std::uint32_t t = 0; t < world_.polygons.size(); ++t)
    {
        if (world_.polygons[t] == PolygonState::active && polygonDroppable(t))
        {
            world_.discardPolygon(t);
        }
    }
}

bool ExactDiscard::sphereDroppable(Kept& kept)
{
    return map_->sphereDroppable(world_.spheres.position(kept.id), world_.spheres.radius[kept.id],
                                 kept.cursor,
                                 [this](int x, int y, int z) { return holdsPlace(x, y, z); });
}

bool ExactDiscard::polygonDroppable(std::uint32_t triangle)
{
    return map_->polygonDroppable(triangle,
                                  [this](int x, int y, int z) { return holdsPlace(x, y, z); });
}

// Whether a reached cube may hold a free place. Many obstacles ask for the same cube, which is
// looked at only once an update.
bool ExactDiscard::holdsPlace(int x, int y, int z)
{
    const VoxelWord cube = map_->layout().at(x, y, z);
    if ((holding_[cube.word] & cube.bits) != 0)
    {
        return true;
    }
    const GridFrame& frame = map_->layout().frame;
    if (clear_->mayBeClear(frame.centre(x, y, z), frame.cell))
    {
        holding_[cube.word] |= cube.bits;
        return true;
    }
    map_->closeCube(x, y, z);
    return false;
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
        if (world_.spheres.state[id] == SphereState::frozen)
        {
            kept_.push_back({id, 0});
        }
    }
    ++violations_;
    build();
}

} // namespace frostfill
