// SPDX-License-Identifier: MIT
#include <simulation/release_sites.hpp>

#include <simulation/clear_place.hpp>
#include <simulation/random.hpp>

#include <algorithm>
#include <utility>

namespace frostfill
{

ReleaseSites::ReleaseSites(const World& world, double radius, double band)
    : world_(world), radius_(radius), sites_(world.surface, world.inside, radius)
{
    findCeilings(band);
}

void ReleaseSites::findCeilings(double band)
{
    const GridFrame& lattice = sites_.lattice();
    const auto row = static_cast<std::size_t>(lattice.count[0]);
    const auto rows = static_cast<std::size_t>(lattice.count[1]);
    const auto height = [&](std::size_t site) { return site / row % rows; };
    for (std::size_t site = sites_.nextOpen(0); site < lattice.size();
         site = sites_.nextOpen(site + 1))
    {
        if (height(site) + 1 == rows || !sites_.isOpen(site + row))
        {
            ceilings_.push_back(static_cast<std::uint32_t>(site));
        }
    }
    std::sort(ceilings_.begin(), ceilings_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              { return std::pair(height(a), a) < std::pair(height(b), b); });
    const double inBand = band / sites_.cell();
    const auto isLow = [&](std::uint32_t site)
    {
        return static_cast<double>(height(site)) + inBand <
               static_cast<double>(height(ceilings_.back()));
    };
    const auto first = std::partition_point(ceilings_.begin(), ceilings_.end(), isLow);
    window_ = static_cast<std::size_t>(ceilings_.end() - first);
}

// The next lower one takes its place in the window.
void ReleaseSites::dropCeiling(std::size_t index)
{
    ceilings_[index] = ceilings_.back();
    ceilings_.pop_back();
    window_ = std::min(window_, ceilings_.size());
}

// One attempt at a random one of the highest ceilings. A ceiling from which nothing can be released
// any more is forgotten; its site stays open for the sweep unless no place is left in it.
std::optional<Eigen::Vector3d> ReleaseSites::drawAtCeiling(std::size_t among)
{
    const std::uint64_t seed = world_.scene.seed;
    const double choice = uniformRandom(seed, ++draws_, 0);
    const auto index =
        ceilings_.size() - 1 - static_cast<std::size_t>(choice * static_cast<double>(among));
    const std::uint32_t site = ceilings_[index];
    lastCeiling_ = index;
    if (sites_.isOpen(site))
    {
        Eigen::Vector3d p = sites_.centre(site);
        p.x() += sites_.cell() * (uniformRandom(seed, draws_, 1) - 0.5);
        p.z() += sites_.cell() * (uniformRandom(seed, draws_, 2) - 0.5);
        if (moveClear(world_, p, radius_, radius_))
        {
            return p;
        }
        p = sites_.centre(site);
        if (moveClear(world_, p, radius_, farthest()))
        {
            return p;
        }
        sites_.closeSite(site);
    }
    dropCeiling(index);
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
        if (moveClear(world_, place_, radius_, farthest()))
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
    dropCeiling(lastCeiling_);
}

} // namespace frostfill
