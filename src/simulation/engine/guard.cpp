// SPDX-License-Identifier: MIT
#include "simulation/engine/guard.hpp"

#include "simulation/engine/tolerances.hpp"

#include <cmath>
#include <limits>

namespace frostfill
{

// Collisions pass speed on, so one sphere can be faster than its own fall makes it. A moving object
// does work on its spheres.
Guard::Guard(World& world) : world_(world), fastest_(std::numeric_limits<double>::max())
{
    if (!world.scene.move.any())
    {
        const double fall = 2 * world.frame.gravity * world.surface.box().diagonal().norm();
        fastest_ = kTooFast * kTooFast * (fall + 1);
    }
}

void Guard::check()
{
    const Eigen::AlignedBox3d& box = world_.surface.box();
    for (const std::uint32_t id : world_.runningIds)
    {
        const Eigen::Vector3d p = world_.spheres.position(id);
        const double speed = world_.spheres.velocity(id).squaredNorm();
        // What is no number is in no box, and below no speed. Near a wall the side takes a
        // distance, which can wait until the sphere is past the wall.
        const bool inBox = box.contains(p);
        const bool slow = speed <= fastest_;
        if (!inBox || !slow || world_.inside.isFarOutside(p))
        {
            const bool finite = p.allFinite() && std::isfinite(speed);
            return report(id, !finite          ? StrayKind::notFinite
                              : inBox && !slow ? StrayKind::tooFast
                                               : StrayKind::outside);
        }
    }
    for (; seen_ < world_.stateChanges.size(); ++seen_)
    {
        const std::uint32_t id = world_.stateChanges[seen_];
        if (id >= world_.spheres.size() || world_.spheres.state[id] != SphereState::frozen)
        {
            continue;
        }
        const Eigen::Vector3d p = world_.spheres.position(id);
        if (!p.allFinite() || !world_.inside.contains(p))
        {
            return report(id, p.allFinite() ? StrayKind::outside : StrayKind::notFinite);
        }
    }
}

void Guard::report(std::uint32_t id, StrayKind kind)
{
    world_.stray = StraySphere{kind, id, world_.frame.toMesh(world_.spheres.position(id)),
                               world_.time * world_.frame.time};
    world_.finished = true;
}

} // namespace frostfill
