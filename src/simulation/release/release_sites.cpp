// SPDX-License-Identifier: MIT
#include "simulation/release/release_sites.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

ReleaseSites::ReleaseSites(const World& world, double radius, double band, Threads& threads)
    : world_(world), threads_(threads), radius_(radius),
      sites_(world.surface, world.inside, radius, threads)
{
    if (band >= 0)
    {
        findCeilings(band);
    }
}

void ReleaseSites::findCeilings(double band)
{
    const auto height = [&](std::size_t site) { return sites_.height(site); };
    ceilings_ = sites_.highest();
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

// Cell by cell of the grid, so that what is closed one after another lies close together in memory.
// On several threads every other slab of cells first, then those between: spheres of one slab close
// no sites that share a word with those of the next but one.
void ReleaseSites::startSweep()
{
    if (sweeping_)
    {
        return;
    }
    sweeping_ = true;
    const SphereGrid& resting = world_.spheres.resting();
    const std::array<int, 3>& count = resting.frame().count;
    const auto closeSlab = [&](int slab)
    {
        const int end = std::min(count[2], (slab + 1) * kSlabThickness);
        resting.forEachInLayers(slab * kSlabThickness, end - 1,
                                [&](std::uint32_t row)
                                { sites_.close(resting[row].position(), resting[row].radius); });
    };
    forEachSlab(threads_, (count[2] + kSlabThickness - 1) / kSlabThickness, closeSlab);
}

// Whether a sphere at rest leaves no place in the site's cell, as SiteLattice::close would find.
bool ReleaseSites::isTaken(std::size_t site) const
{
    const Eigen::Vector3d centre = sites_.centre(site);
    bool taken = false;
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(centre, radius_ + 1,
                        [&](std::uint32_t row)
                        {
                            const Ball& sphere = resting[row];
                            const double limit = sites_.closedWithin(sphere.radius);
                            taken = taken ||
                                    (limit > 0 &&
                                     (sphere.position() - centre).squaredNorm() <= limit * limit);
                        });
    return taken;
}

// The next lower one takes its place in the window.
void ReleaseSites::dropCeiling(std::size_t index)
{
    ceilings_[index] = ceilings_.back();
    ceilings_.pop_back();
    window_ = std::min(window_, ceilings_.size());
}

std::size_t ReleaseSites::ceilingOfDraw(std::uint64_t number, std::size_t among) const
{
    const double choice = uniformRandom(world_.scene.seed, number, 0);
    return ceilings_.size() - 1 - static_cast<std::size_t>(choice * static_cast<double>(among));
}

// A site was opened inside, where walls are farther away than this.
Start ReleaseSites::startWithin(double way) const
{
    return way < radius_ - sites_.halfDiagonal() ? Start::inside : Start::anywhere;
}

// A clear place at a random point of the ceiling, or at its middle.
std::optional<Eigen::Vector3d> ReleaseSites::placeOfDraw(std::uint64_t number,
                                                         std::uint32_t site) const
{
    if (!sites_.isOpen(site) || isTaken(site))
    {
        return std::nullopt;
    }
    const std::uint64_t seed = world_.scene.seed;
    Eigen::Vector3d p = sites_.centre(site);
    // By at most half a cell along two axes.
    p.x() += sites_.cell() * (uniformRandom(seed, number, 1) - 0.5);
    p.z() += sites_.cell() * (uniformRandom(seed, number, 2) - 0.5);
    if (depenetrate(world_, p, radius_, radius_, kMoves, startWithin(sites_.cell())))
    {
        return p;
    }
    p = sites_.centre(site);
    if (depenetrate(world_, p, radius_, farthest(), kMoves, startWithin(0)))
    {
        return p;
    }
    return std::nullopt;
}

// A ceiling from which nothing can be released any more is forgotten.
std::optional<Eigen::Vector3d> ReleaseSites::take(const Draw& draw, std::size_t among)
{
    lastCeiling_ = ceilingOfDraw(draw.number, among);
    ++sinceForgotten_;
    if (!draw.place)
    {
        sinceForgotten_ = 0;
        sites_.closeSite(draw.site);
        dropCeiling(lastCeiling_);
    }
    return draw.place;
}

// The first open site from `site` on that has a clear place, which becomes place_; sites that turn
// out to have none are closed.
std::size_t ReleaseSites::nextFree(std::size_t site)
{
    for (site = sites_.nextOpen(site); site < sites_.end(); site = sites_.nextOpen(site + 1))
    {
        place_ = sites_.centre(site);
        if (depenetrate(world_, place_, radius_, farthest(), kMoves, startWithin(0)))
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
