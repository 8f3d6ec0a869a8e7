// SPDX-License-Identifier: MIT
#include <simulation/release_sites.hpp>

#include <simulation/clear_place.hpp>
#include <simulation/random.hpp>

namespace frostfill
{
namespace
{

/// How far from its site a place may be that stands for it. [r]
constexpr double kFarthest = 2 * OpenSites::kHalfDiagonal;

} // namespace

ReleaseSites::ReleaseSites(const World& world) : world_(world), sites_(world.surface, world.inside)
{
    findCeilings();
}

void ReleaseSites::findCeilings()
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

// One attempt at a random ceiling. A ceiling from which nothing can be released any more is
// forgotten; its site stays open for the sweep unless no place is left in it.
std::optional<Eigen::Vector3d> ReleaseSites::drawAtCeiling()
{
    const std::uint64_t seed = world_.scene.seed;
    const double choice = uniformRandom(seed, ++draws_, 0);
    const auto index = static_cast<std::size_t>(choice * static_cast<double>(ceilings_.size()));
    const std::uint32_t site = ceilings_[index];
    lastCeiling_ = index;
    if (sites_.isOpen(site))
    {
        Eigen::Vector3d p = sites_.centre(site);
        p.x() += OpenSites::kCell * (uniformRandom(seed, draws_, 1) - 0.5);
        p.z() += OpenSites::kCell * (uniformRandom(seed, draws_, 2) - 0.5);
        if (moveClear(world_, p, 1, 1))
        {
            return p;
        }
        p = sites_.centre(site);
        if (moveClear(world_, p, 1, kFarthest))
        {
            return p;
        }
        sites_.closeSite(site);
    }
    ceilings_[index] = ceilings_.back();
    ceilings_.pop_back();
    return std::nullopt;
}

// The first open site from `site` on that has a clear place, which becomes place_; sites that turn
// out to have none are closed.
std::size_t ReleaseSites::nextFree(std::size_t site)
{
    for (site = sites_.nextOpen(site); site < sites_.lattice().size();
         site = sites_.nextOpen(site + 1))
    {
        place_ = sites_.centre(site);
        if (moveClear(world_, place_, 1, kFarthest))
        {
            return site;
        }
        sites_.closeSite(site);
    }
    return site;
}

void ReleaseSites::giveUp()
{
    if (ceilings_.empty())
    {
        sites_.closeSite(lastFree_);
        return;
    }
    ceilings_[lastCeiling_] = ceilings_.back();
    ceilings_.pop_back();
}

} // namespace frostfill
