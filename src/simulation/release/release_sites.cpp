// SPDX-License-Identifier: MIT
#include "simulation/release/release_sites.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

ReleaseSites::ReleaseSites(const World& world, double radius, double band, Threads& threads,
                           double coarsest)
    : world_(world), threads_(threads), radius_(radius),
      sites_(world.surface, world.inside, radius, threads, kSmallLattice, coarsest)
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

// Closes cell by cell of the grid, so that what is closed one after another lies close together in
// memory. On several threads every other slab of cells first, then those between: spheres of one
// slab close no sites that share a word with those of the next but one.
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

// Whether the site was closed, or a sphere at rest leaves no place in its cell, as
// SiteLattice::close would find.
bool ReleaseSites::isTaken(std::size_t site) const
{
    if (!sites_.isOpen(site))
    {
        return true;
    }
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

std::optional<ReleaseSites::Found> ReleaseSites::find(double radius, const ReleaseQuery& query,
                                                      const std::function<void()>& lookAhead)
{
    for (const bool highOnly : {true, false})
    {
        highOnly_ = highOnly;
        for (int misses = 0; misses < kMaxMisses && !ceilings_.empty() && !query.isStopped();)
        {
            const Draw& draw = take(nextDraw(radius, query, lookAhead));
            const bool isBlocked = query.search != 0 && draw.blockedIn == query.search;
            if (draw.place && (!draw.stays || (!isBlocked && query.suits(*draw.place, radius))))
            {
                return Found{*draw.place, draw.stays};
            }
            misses += draw.place ? 1 : 0; // else a ceiling is forgotten, which ends by itself
        }
    }
    return ceilings_.empty() ? sweep(radius, query) : std::nullopt;
}

std::optional<Eigen::Vector3d> ReleaseSites::findLasting(double radius, const ReleaseQuery& query,
                                                         const std::function<void()>& lookAhead)
{
    while (const auto found = find(radius, query, lookAhead))
    {
        if (found->stays)
        {
            return found->place;
        }
        giveUp();
    }
    return std::nullopt;
}

std::optional<ReleaseSites::Found> ReleaseSites::sweep(double radius, const ReleaseQuery& query)
{
    startSweep();
    sweep_ = sites_.nextOpen(sweep_);
    int misses = 0;
    std::size_t first = sweep_;
    if (scattered_)
    {
        const double share = uniformRandom(world_.scene.seed, ++draws_, kGapDraw);
        first =
            sites_.nextOpen(static_cast<std::size_t>(share * static_cast<double>(sites_.end())));
        first = first < sites_.end() ? first : sweep_;
    }
    for (std::size_t site = nextFree(first, query);
         site < sites_.end() && (!query.givesUp || misses < kMaxMisses);
         site = nextFree(site + 1, query))
    {
        Eigen::Vector3d place = place_;
        Footprint unused;
        const bool stays = !query.prepare || query.prepare(place, radius, unused);
        if (!stays || query.suits(place, radius))
        {
            lastFree_ = site;
            return Found{place, stays};
        }
        ++misses;
    }
    if (scattered_ && first > sweep_)
    {
        scattered_ = false; // whatever is before that place
        std::optional<Found> found = sweep(radius, query);
        scattered_ = true;
        return found;
    }
    return std::nullopt;
}

bool ReleaseSites::any()
{
    return find(radius_, {.suits = [](const Eigen::Vector3d&, double) { return true; }})
        .has_value();
}

// The first open site from `site` on that has a clear place, which becomes place_; sites that turn
// out to have none are closed. None once the search is stopped.
std::size_t ReleaseSites::nextFree(std::size_t site, const ReleaseQuery& query)
{
    for (site = sites_.nextOpen(site); site < sites_.end() && !query.isStopped();
         site = sites_.nextOpen(site + 1))
    {
        place_ = sites_.centre(site);
        if (depenetrate(world_, place_, radius_, farthest(), kMoves, startWithin(0)))
        {
            return site;
        }
        sites_.closeSite(site);
    }
    return sites_.end();
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
