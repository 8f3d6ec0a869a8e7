// SPDX-License-Identifier: MIT
#include <simulation/descent_engine.hpp>

#include <simulation/clear_place.hpp>
#include <simulation/random.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

/// A run is recorded as at most so many sets.
constexpr std::size_t kMostSets = 200;

} // namespace

DescentEngine::DescentEngine(World& world)
    : world_(world), falls_(world.resting.frame(), world.triangles),
      sites_(world.surface, world.inside), descent_(world, falls_)
{
    const SphereSettings& spheres = world.scene.spheres;
    setSize_ = std::max<std::size_t>(std::size_t{spheres.groupSize} * spheres.groupsPerSet,
                                     expectedCount(world) / kMostSets);
    findCeilings();
}

void DescentEngine::findCeilings()
{
    const GridFrame& lattice = sites_.lattice();
    const auto row = static_cast<std::size_t>(lattice.count[0]);
    for (std::size_t site = sites_.nextOpen(0); site < lattice.size();
         site = sites_.nextOpen(site + 1))
    {
        const auto y = static_cast<int>(site / row % static_cast<std::size_t>(lattice.count[1]));
        if (y + 1 == lattice.count[1] || !sites_.isOpen(site + row))
        {
            ceilings_.push_back(static_cast<std::uint32_t>(site));
        }
    }
}

bool DescentEngine::step()
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
    clock_.close(world_);
    world_.finished = world_.full || world_.spheres.size() == world_.targetCount;
    return true;
}

// Returns false when no place is left.
bool DescentEngine::placeOne()
{
    while (auto place = nextRelease())
    {
        if (descent_.settle(*place, 1))
        {
            const auto group =
                static_cast<std::uint32_t>(world_.spheres.size() / world_.scene.spheres.groupSize);
            world_.freeze(world_.spheres.add(*place, 1, group));
            falls_.insert(*place);
            sites_.close(*place, 1);
            return true;
        }
        if (ceilings_.empty())
        {
            sites_.closeSite(sweep_);
        }
    }
    return false;
}

std::optional<Eigen::Vector3d> DescentEngine::nextRelease()
{
    const auto place = releaseAtCeiling();
    return place ? place : releaseAnywhere();
}

std::optional<Eigen::Vector3d> DescentEngine::releaseAtCeiling()
{
    while (!ceilings_.empty())
    {
        const double choice = uniformRandom(world_.scene.seed, ++draws_, 0);
        const auto index = static_cast<std::size_t>(choice * static_cast<double>(ceilings_.size()));
        const std::uint32_t site = ceilings_[index];
        if (sites_.isOpen(site))
        {
            Eigen::Vector3d p = sites_.centre(site);
            p.x() += OpenSites::kCell * (uniformRandom(world_.scene.seed, draws_, 1) - 0.5);
            p.z() += OpenSites::kCell * (uniformRandom(world_.scene.seed, draws_, 2) - 0.5);
            if (moveClear(world_, p, 1, 1))
            {
                return p;
            }
            p = sites_.centre(site);
            if (moveClear(world_, p, 1, 2 * OpenSites::kHalfDiagonal))
            {
                return p;
            }
            sites_.closeSite(site);
        }
        ceilings_[index] = ceilings_.back();
        ceilings_.pop_back();
    }
    return std::nullopt;
}

std::optional<Eigen::Vector3d> DescentEngine::releaseAnywhere()
{
    while ((sweep_ = sites_.nextOpen(sweep_)) < sites_.lattice().size())
    {
        Eigen::Vector3d p = sites_.centre(sweep_);
        if (moveClear(world_, p, 1, 2 * OpenSites::kHalfDiagonal))
        {
            return p;
        }
        sites_.closeSite(sweep_);
    }
    return std::nullopt;
}

} // namespace frostfill
