// SPDX-License-Identifier: MIT
// How FastEngine follows an object that moves: once it is filled and at rest, gravity turns, and
// the spheres at rest that it pulls out of the cone of their contacts run again, with all that
// rested on them; everything else stays frozen.

#include "simulation/contact/contact_cone.hpp"
#include "simulation/engine/fast_engine.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kWakes = 0.05; // share of the pull that must be uncarried; freezing asks 0.01
constexpr double kTouch = 1e-6; // gap below which a contact carries [own radius]
constexpr double kSameDirection = 0.005; // change of direction that is not worth a look

} // namespace

// Returns false when the object does not move, or has come to rest with all in it.
bool FastEngine::followObject()
{
    if (world_.motion.duration() == 0)
    {
        return false;
    }
    if (!moving_)
    {
        if (motionIsOver_)
        {
            return false;
        }
        // What was out of reach need not stay so.
        moving_ = true;
        lookedAt_ = directionsAtCorners();
        world_.motionStart = world_.time;
        discard_.reset();
        world_.restoreDiscarded();
        clock_.close(world_);
        clock_.open(world_, 0);
    }
    if (world_.time - world_.motionStart >= world_.motion.duration() && running_ == 0)
    {
        wake(); // by the last word of gravity, whatever was looked at before
        if (running_ == 0)
        {
            moving_ = false;
            motionIsOver_ = true;
            return false;
        }
    }
    return true;
}

// The sites of releases are closed for good where something has been at rest; now they are looked
// for anew, for spheres that find no room where they are.
void FastEngine::renewSites()
{
    release_.emplace(world_, -1, threads_);
    sitesAreNew_ = true;
}

std::array<Eigen::Vector3d, 8> FastEngine::directionsAtCorners() const
{
    std::array<Eigen::Vector3d, 8> directions;
    for (std::size_t corner = 0; corner < directions.size(); ++corner)
    {
        const auto which = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        directions[corner] = world_.pull.direction(world_.surface.box().corner(which));
    }
    return directions;
}

void FastEngine::wakeWhenDue()
{
    if (!moving_)
    {
        return;
    }
    if (!sitesAreNew_ && world_.time - world_.motionStart >= world_.motion.duration())
    {
        renewSites();
    }
    const std::array<Eigen::Vector3d, 8> now = directionsAtCorners();
    double change = 0;
    for (std::size_t corner = 0; corner < now.size(); ++corner)
    {
        change = std::max(change, (now[corner] - lookedAt_[corner]).norm());
    }
    if (change > kSameDirection)
    {
        wake();
    }
}

// Looks at all spheres at rest, then again at those that one let go may have carried.
void FastEngine::wake()
{
    lookedAt_ = directionsAtCorners();
    std::vector<std::uint32_t> toLookAt;
    for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
    {
        if (world_.spheres.state[id] != SphereState::running)
        {
            toLookAt.push_back(id);
        }
    }
    bool any = false;
    while (!toLookAt.empty())
    {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t id : toLookAt)
        {
            if (world_.spheres.state[id] == SphereState::running || isSupported(id))
            {
                continue;
            }
            any = true;
            unfreeze(id);
            const Eigen::Vector3d place = world_.spheres.position(id);
            const double radius = world_.spheres.radius[id];
            world_.resting.forEachNear(place, radius + 1 + kTouch,
                                       [&](std::uint32_t other)
                                       {
                                           const GridSphere& near = world_.resting[other];
                                           const double contact = radius + near.radius + kTouch;
                                           if ((near.position() - place).squaredNorm() <
                                               contact * contact)
                                           {
                                               next.push_back(other);
                                           }
                                       });
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        toLookAt = std::move(next);
    }
    for (std::size_t k = 0; any && k < running_; ++k)
    {
        runners_[k].around.invalidate(); // it may list what is not at rest any more
        runners_[k].yields = true;
    }
}

bool FastEngine::isSupported(std::uint32_t id)
{
    const Eigen::Vector3d place = world_.spheres.position(id);
    const double radius = world_.spheres.radius[id];
    const double gap = kTouch * radius;
    const Eigen::Vector3d down = world_.pull.direction(place);
    normals_.clear();
    world_.resting.forEachNear(place, radius + 1 + gap,
                               [&](std::uint32_t other)
                               {
                                   const GridSphere& near = world_.resting[other];
                                   const Eigen::Vector3d d = place - near.position();
                                   const double contact = radius + near.radius + gap;
                                   const double squared = d.squaredNorm();
                                   if (other != id && squared < contact * contact)
                                   {
                                       normals_.push_back(d / std::sqrt(squared));
                                   }
                               });
    for (const std::uint32_t t : world_.triangles.near(place))
    {
        if (!world_.surface.bound(t).mayBeWithin(radius + gap, place))
        {
            continue;
        }
        const SignedDistance wall = signedDistance(world_.surface[t], place);
        if (wall.value > 0 && wall.value < radius + gap)
        {
            normals_.push_back((place - wall.closest) / wall.value);
        }
    }
    return projectToFree(down, normals_).norm() <= kWakes;
}

void FastEngine::unfreeze(std::uint32_t id)
{
    world_.unfreeze(id);
    if (running_ == runners_.size())
    {
        runners_.emplace_back();
    }
    runners_[running_++].restart(id, world_.spheres.position(id), world_.spheres.radius[id]);
}

} // namespace frostfill
