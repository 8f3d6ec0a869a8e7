// SPDX-License-Identifier: MIT
#include "simulation/release/release_rule.hpp"

#include "simulation/release/gap_releases.hpp"
#include "simulation/release/inlets.hpp"
#include "simulation/release/releases.hpp"
#include "simulation/release/tolerances.hpp"

#include <algorithm>

namespace frostfill
{

std::unique_ptr<ReleasePart> makeRelease(const World& world, double band, Threads& threads)
{
    if (!world.scene.spheres.inlets.empty())
    {
        return std::make_unique<Inlets>(world);
    }
    if (world.scene.spheres.sizes.fillGaps)
    {
        return std::make_unique<GapReleases>(world, band, threads);
    }
    return std::make_unique<Releases>(world, band, threads);
}

std::size_t releaseAmong(const RunningSpheres& runners, RunnerGrid& grid, std::size_t wanted,
                         ReleasePart& release, ReleaseQuery query, const StopRequest& stop,
                         const std::function<void(const PlacedSphere&)>& appear)
{
    query.stop = &stop;
    query.givesUp = true; // when those that run have come to rest, every free place suits
    query.suits = [&grid](const Eigen::Vector3d& place, double radius)
    { return grid.isClear(place, radius); };
    grid.rebuild(runners);
    std::size_t found = 0;
    while (found < wanted && !stop.isAsked())
    {
        query.ahead = std::clamp(wanted - found, kFewestDrawsAhead, kDrawsAhead);
        const auto next = release.next(query);
        if (!next)
        {
            break;
        }
        grid.add(next->place, next->radius);
        appear(*next);
        ++found;
    }
    return found;
}

void endForWantOfPlaces(World& world, const ReleasePart& release)
{
    if (wantedOfSet(world, 1) == 0)
    {
        return;
    }
    (release.findsEveryPlace() ? world.clock.full : world.clock.inletsReached) = true;
}

} // namespace frostfill
