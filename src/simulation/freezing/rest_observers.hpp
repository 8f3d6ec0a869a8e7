// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/fall_index.hpp"
#include "simulation/release/release_rule.hpp"

#include <memory>

namespace frostfill
{

/// What depends on the spheres at rest. It knows those that are at rest when it is made, and is
/// updated for each that comes to rest: where falls end, and where spheres can appear.
struct RestObservers
{
    RestObservers(World& world, double band, Threads& threads)
        : resting(world.spheres.resting()), falls(resting, world.triangles),
          release(makeRelease(world, band, threads))
    {
        for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
        {
            add(world.spheres.position(id), world.spheres.radius(id));
        }
    }

    /// A sphere has come to rest. If it runs again, falls look where it was in vain, and nothing
    /// appears there any more.
    void add(const Eigen::Vector3d& place, double radius)
    {
        falls.insert(place, resting.levelFor(radius));
        release->close(place, radius);
    }

    const SphereGrid& resting;
    FallIndex falls;
    std::unique_ptr<ReleasePart> release;
};

} // namespace frostfill
