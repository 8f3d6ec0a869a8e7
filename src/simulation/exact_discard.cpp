// SPDX-License-Identifier: MIT
#include <simulation/exact_discard.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr std::size_t kSmallestBatch = 20; // spheres at rest between two updates, at least
constexpr std::size_t kBatches = 100;      // updates in a run, at most

} // namespace

ExactDiscard::ExactDiscard(World& world)
    : world_(world), batch_(std::max(kSmallestBatch, expectedCount(world) / kBatches))
{
    build();
    drop();
}

void ExactDiscard::build()
{
    ReachMap::Margins margins;
    const double smallest = world_.radii.smallest();
    margins.overlap *= margin_ * smallest;
    margins.step *= margin_ * smallest;
    margins.query *= margin_;
    map_ = std::make_unique<ReachMap>(world_.surface, world_.inside, ReachMap::Radii{smallest, 1},
                                      margins);
    for (const Kept& kept : kept_)
    {
        map_->addResting(world_.spheres.position(kept.id), world_.spheres.radius[kept.id]);
    }
    map_->flood(centres_);
}

void ExactDiscard::addResting(std::uint32_t id)
{
    map_->addResting(world_.spheres.position(id), world_.spheres.radius[id]);
    kept_.push_back({id, 0});
    ++pending_;
}

void ExactDiscard::update(std::span<const Runner> runners)
{
    pending_ = 0;
    centres_.clear();
    for (const Runner& runner : runners)
    {
        centres_.push_back(runner.position);
    }
    if (!map_->active())
    {
        return;
    }
    if (!map_->update(centres_))
    {
        restoreAll();
    }
    drop();
}

void ExactDiscard::drop()
{
    std::erase_if(kept_,
                  [this](Kept& kept)
                  {
                      const bool droppable =
                          map_->sphereDroppable(world_.spheres.position(kept.id),
                                                world_.spheres.radius[kept.id], kept.cursor);
                      if (droppable)
                      {
                          world_.discard(kept.id);
                      }
                      return droppable;
                  });
    for (std::uint32_t t = 0; t < world_.polygons.size(); ++t)
    {
        if (world_.polygons[t] == PolygonState::active && map_->polygonDroppable(t))
        {
            world_.discardPolygon(t);
        }
    }
}

// A guard has tripped: some centre is where the map says that none can be. Everything comes back,
// and the map is made anew with wider margins; two such in a row end in a map that drops nothing.
void ExactDiscard::restoreAll()
{
    world_.restoreDiscarded();
    kept_.clear();
    for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
    {
        if (world_.spheres.state[id] == SphereState::frozen)
        {
            kept_.push_back({id, 0});
        }
    }
    margin_ *= 2;
    build();
}

} // namespace frostfill
