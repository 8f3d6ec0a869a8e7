// SPDX-License-Identifier: MIT
#include "simulation/motion/free_flight.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "simulation/motion/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Displacement that a renewed neighbour list has room for at least. [r]
constexpr double kLookAhead = kShareOfSkin * NeighbourList::kSkin;

// Displacement within the time under gravity, as far as the contacts let it.
Eigen::Vector3d freeWay(const Runner& runner, double time, const Eigen::Vector3d& gravity)
{
    return projectToFree(time * runner.velocity + 0.5 * time * time * gravity, runner.normals);
}

} // namespace

void Runner::restart(std::uint32_t newId, const Eigen::Vector3d& p, double newRadius)
{
    id = newId;
    radius = newRadius;
    position = p;
    watched = p;
    velocity.setZero();
    around.invalidate();
    age = 0;
    stillWindows = 0;
    yields = true;
    stale = false;
    carriedAt.reset();
}

void FreeFlight::advance(Runner& runner, double dt) const
{
    const Eigen::Vector3d gravity = world_.pull.at(runner.position, runner.velocity);
    const double strength = std::max(1.0, gravity.norm());
    double left = dt;
    const double longest = dt * (runner.velocity.norm() + strength * dt);
    const int mostParts = kMostParts + static_cast<int>(longest / kLookAhead);
    for (int part = 0; part < mostParts && left > kNoTimeLeft * dt; ++part)
    {
        const double ahead = left * (runner.velocity.norm() + strength * left);
        runner.around.ensure(world_, runner.position, runner.radius, std::min(ahead, kLookAhead));
        contactNormals(world_.surface, runner.around, runner.position, runner.radius, kTouch,
                       runner.normals);
        collide(runner);

        // The chord of the parabola over as much of the time as the neighbourhood reaches. Where a
        // contact ends it early, the speed is that of an earlier point of the parabola: energy is
        // lost there, never gained.
        double time = left;
        Eigen::Vector3d way = freeWay(runner, time, gravity);
        const double room = runner.around.room(runner.position);
        while (way.norm() > room)
        {
            time *= std::clamp(kIntoTheList * room / way.norm(), kShortestTry, kIntoTheList);
            way = freeWay(runner, time, gravity);
        }
        const double length = way.norm();
        if (length < kStandsStill)
        {
            runner.velocity = projectToFree(runner.velocity + time * gravity, runner.normals);
            left -= time;
            continue;
        }
        const Eigen::Vector3d direction = way / length;
        const double path = sphereCast(world_.surface, runner.around, runner.position,
                                       runner.radius, direction, length);
        const double share = path / length;
        runner.position += path * direction;
        runner.velocity = projectToFree(runner.velocity + share * time * gravity, runner.normals);
        if (!runner.normals.empty())
        {
            runner.velocity *= 1 - std::min(1.0, settings_.damping * share * time);
        }
        left -= path < length ? share * time : time;
    }
    findContacts(runner, kTouch);
    collide(runner);
}

void FreeFlight::findContacts(Runner& runner, double gap) const
{
    runner.around.ensure(world_, runner.position, runner.radius, 0);
    runner.position += contactNormals(world_.surface, runner.around, runner.position, runner.radius,
                                      gap, runner.normals);
}

// Contacts that are approached fast are bounced off one after another; then whatever still leads
// into a contact is lost. Neither adds energy when restitution is at most 1.
void FreeFlight::collide(Runner& runner) const
{
    const Restitution restitution{settings_.restitution, settings_.bounceSpeed};
    for (const Eigen::Vector3d& normal : runner.normals)
    {
        const double approach = normal.dot(runner.velocity);
        if (restitution.bounces(approach))
        {
            runner.velocity += restitution.change(approach) * normal;
        }
    }
    runner.velocity = projectToFree(runner.velocity, runner.normals);
}

void FreeFlight::shift(Runner& runner, const Eigen::Vector3d& displacement) const
{
    Eigen::Vector3d left = displacement;
    for (int part = 0; part < kMostShifts; ++part)
    {
        const double length = left.norm();
        if (length < kStandsStill)
        {
            return;
        }
        runner.around.ensure(world_, runner.position, runner.radius, std::min(length, kLookAhead));
        const double limit = std::min(length, runner.around.room(runner.position));
        const Eigen::Vector3d direction = left / length;
        const double path = sphereCast(world_.surface, runner.around, runner.position,
                                       runner.radius, direction, limit);
        runner.position += path * direction;
        if (path >= limit)
        {
            return;
        }
        contactNormals(world_.surface, runner.around, runner.position, runner.radius, kTouch,
                       runner.normals);
        left = projectToFree((length - path) * direction, runner.normals);
    }
}

} // namespace frostfill
