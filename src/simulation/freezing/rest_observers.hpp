// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/discard/discard_rule.hpp"
#include "simulation/motion/fall_index.hpp"
#include "simulation/release/release_rule.hpp"

#include <memory>

namespace frostfill
{

/// What depends on the spheres at rest. It knows those that are at rest when it is made, and is
/// updated for each that comes to rest: where falls end, where spheres can appear, and what is
/// discarded.
struct RestObservers
{
    RestObservers(World& world, double band, Threads& threads)
        : resting(world.spheres.resting()), falls(resting, world.triangles),
          release(makeRelease(world, band, threads)), discard(makeDiscard(world, threads))
    {
        for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
        {
            add(id, world.spheres.position(id), world.spheres.radius(id));
        }
    }

    /// Sphere `id` has come to rest.
    void add(std::uint32_t id, const Eigen::Vector3d& place, double radius)
    {
        falls.insert(place, resting.levelFor(radius));
        release->close(place, radius);
        if (discard)
        {
            discard->addResting(id);
        }
    }

    /// It runs again, before anything else has been done about it. Falls look where it was in vain,
    /// and nothing appears there any more.
    void takeBack(std::uint32_t id)
    {
        if (discard)
        {
            discard->takeBack(id);
        }
    }

    const SphereGrid& resting;
    FallIndex falls;
    std::unique_ptr<ReleasePart> release;
    std::unique_ptr<DiscardPart> discard; ///< empty when nothing is to be discarded
};

} // namespace frostfill
