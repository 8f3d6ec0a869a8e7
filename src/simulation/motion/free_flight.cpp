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
Eigen::Vector3d freeWay(const Eigen::Vector3d& velocity, double time,
                        const Eigen::Vector3d& gravity, std::span<const Eigen::Vector3d> normals)
{
    return projectToFree(time * velocity + 0.5 * time * time * gravity, normals);
}

} // namespace

FreeFlight::FreeFlight(World& world, const Settings& settings)
    : world_(world), running_(world.spheres.running()), settings_(settings),
      around_(running_, [](std::uint32_t, NeighbourList& around) { around.invalidate(); }),
      normals_(running_)
{
}

void FreeFlight::advance(std::uint32_t row, double dt)
{
    Eigen::Vector3d& position = running_.position[row];
    Eigen::Vector3d& velocity = running_.velocity[row];
    const double radius = running_.radius[row];
    NeighbourList& around = around_[row];
    std::vector<Eigen::Vector3d>& normals = normals_[row];
    const Eigen::Vector3d gravity = world_.pull.at(position, velocity);
    const double strength = std::max(1.0, gravity.norm());
    double left = dt;
    const double longest = dt * (velocity.norm() + strength * dt);
    const int mostParts = kMaxParts + static_cast<int>(longest / kLookAhead);
    for (int part = 0; part < mostParts && left > kNegligible * dt; ++part)
    {
        const double ahead = left * (velocity.norm() + strength * left);
        around.ensure(world_, position, radius, std::min(ahead, kLookAhead));
        contactNormals(world_.surface, around, position, radius, kTouch, normals);
        collide(velocity, normals);

        // The chord of the parabola over as much of the time as the neighbourhood reaches. Where a
        // contact ends it early, the speed is that of an earlier point of the parabola: energy is
        // lost there, never gained.
        const Rolling rolling = roll(row, gravity);
        if (rolling.stands)
        {
            velocity.setZero();
            break;
        }
        const Eigen::Vector3d& pull = rolling.pull;
        double time = std::min(left, rolling.time);
        Eigen::Vector3d way = freeWay(velocity, time, pull, normals);
        const double room = around.room(position);
        while (way.norm() > room)
        {
            time *= std::clamp(kIntoTheList * room / way.norm(), kShortestTry, kIntoTheList);
            way = freeWay(velocity, time, pull, normals);
        }
        const double length = way.norm();
        if (length < kNegligible)
        {
            velocity = projectToFree(velocity + time * pull, normals);
            left -= time;
            continue;
        }
        const Eigen::Vector3d direction = way / length;
        const double path = sphereCast(world_.surface, around, position, radius, direction, length);
        const double share = path / length;
        position += path * direction;
        velocity = projectToFree(velocity + share * time * pull, normals);
        if (!normals.empty() && !settings_.rolling.any())
        {
            velocity *= 1 - std::min(1.0, settings_.damping * share * time);
        }
        left -= path < length ? share * time : time;
    }
    findContacts(row, kTouch);
    collide(velocity, normals);
}

// In the air, and where nothing resists rolling, it goes on as it is pulled.
Rolling FreeFlight::roll(std::uint32_t row, const Eigen::Vector3d& gravity)
{
    if (!settings_.rolling.any() || normals_[row].empty())
    {
        return {.pull = gravity};
    }
    return rollAlong(settings_.rolling, running_.velocity[row], gravity, normals_[row],
                     leverOf(row));
}

// On a sphere the reduced radius is less than its own; of several the least counts.
double FreeFlight::leverOf(std::uint32_t row)
{
    const Eigen::Vector3d& p = running_.position[row];
    double lever = 1;
    for (const Ball& other : around_[row].spheres())
    {
        if (sphereContact(p - other.position(), other.radius, kTouch))
        {
            lever = std::min(lever, 1 - running_.radius[row] / other.radius); // a sum of radii
        }
    }
    return lever;
}

bool FreeFlight::isHeld(std::uint32_t row)
{
    if (!settings_.rolling.any())
    {
        return false;
    }
    findContacts(row, kTouch);
    const Eigen::Vector3d& velocity = running_.velocity[row];
    return velocity.norm() < kStandsStill &&
           holdsStanding(settings_.rolling, pullAt(running_.position[row], velocity), normals_[row],
                         leverOf(row));
}

void FreeFlight::findContacts(std::uint32_t row, double gap)
{
    Eigen::Vector3d& position = running_.position[row];
    const double radius = running_.radius[row];
    around_[row].ensure(world_, position, radius, 0);
    position += contactNormals(world_.surface, around_[row], position, radius, gap, normals_[row]);
}

// Contacts that are approached fast are bounced off one after another; then whatever still leads
// into a contact is lost. Neither adds energy when restitution is at most 1.
void FreeFlight::collide(Eigen::Vector3d& velocity, std::span<const Eigen::Vector3d> normals) const
{
    const Restitution& restitution = settings_.restitution;
    for (const Eigen::Vector3d& normal : normals)
    {
        const double approach = normal.dot(velocity);
        if (restitution.bounces(approach))
        {
            velocity += restitution.change(approach) * normal;
        }
    }
    velocity = projectToFree(velocity, normals);
}

void FreeFlight::forgetNeighbours()
{
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        around_[row].invalidate();
    }
}

void FreeFlight::shift(std::uint32_t row, const Eigen::Vector3d& displacement)
{
    Eigen::Vector3d& position = running_.position[row];
    const double radius = running_.radius[row];
    NeighbourList& around = around_[row];
    std::vector<Eigen::Vector3d>& normals = normals_[row];
    Eigen::Vector3d left = displacement;
    for (int part = 0; part < kMaxShifts; ++part)
    {
        const double length = left.norm();
        if (length < kNegligible)
        {
            return;
        }
        around.ensure(world_, position, radius, std::min(length, kLookAhead));
        const double limit = std::min(length, around.room(position));
        const Eigen::Vector3d direction = left / length;
        const double path = sphereCast(world_.surface, around, position, radius, direction, limit);
        position += path * direction;
        if (path >= limit)
        {
            return;
        }
        contactNormals(world_.surface, around, position, radius, kTouch, normals);
        left = projectToFree((length - path) * direction, normals);
    }
}

} // namespace frostfill
