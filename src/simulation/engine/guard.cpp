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
    const RunningSpheres& running = world_.spheres.running();
    const bool asksSide = world_.clock.steps % kStepsPerSide == 0;
    for (std::uint32_t row = 0; row < running.size(); ++row)
    {
        const Eigen::Vector3d& p = running.position[row];
        const double speed = running.velocity[row].squaredNorm();
        // A place that is not finite is in no box, and such a speed is below no limit. The side
        // takes longer: it is asked for seldom, and not near a wall, where it takes a distance.
        const bool inBox = box.contains(p);
        const bool slow = speed <= fastest_;
        if (!inBox || !slow || (asksSide && world_.inside.isFarOutside(p)))
        {
            const bool finite = p.allFinite() && std::isfinite(speed);
            return report(running.id[row], !finite          ? StrayKind::notFinite
                                           : inBox && !slow ? StrayKind::tooFast
                                                            : StrayKind::outside);
        }
    }
    world_.spheres.forEachChangedSince(seen_, [this](std::uint32_t id) { checkAtRest(id); });
}

void Guard::checkAtRest(std::uint32_t id)
{
    if (world_.clock.stray || id >= world_.spheres.size() ||
        world_.spheres.state(id) != SphereState::frozen)
    {
        return;
    }
    const Eigen::Vector3d p = world_.spheres.position(id);
    if (!p.allFinite() || !world_.inside.contains(p))
    {
        report(id, p.allFinite() ? StrayKind::outside : StrayKind::notFinite);
    }
}

void Guard::report(std::uint32_t id, StrayKind kind)
{
    world_.clock.stray = StraySphere{kind, id, world_.frame.toMesh(world_.spheres.position(id)),
                                     world_.clock.time * world_.frame.time};
    world_.clock.finished = true;
}

} // namespace frostfill
