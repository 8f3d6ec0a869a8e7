// SPDX-License-Identifier: MIT
#include "simulation/release/release_rule.hpp"

#include "simulation/release/gap_releases.hpp"
#include "simulation/release/inlets.hpp"
#include "simulation/release/releases.hpp"

namespace frostfill
{

PartTable<ReleaseRule, MakeRelease>& releaseRules()
{
    static PartTable<ReleaseRule, MakeRelease> table = {
        [](const World& world, double band, Threads& threads)
        { return std::make_unique<Releases>(world, band, threads); }, // ceilings
    };
    return table;
}

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
    return releaseRules()[world.scene.spheres.release](world, band, threads);
}

void endForWantOfPlaces(World& world, const ReleasePart& release)
{
    if (world.targetCount > 0 && world.spheres.size() >= world.targetCount)
    {
        return;
    }
    (release.findsEveryPlace() ? world.clock.full : world.clock.inletsReached) = true;
}

} // namespace frostfill
