// SPDX-License-Identifier: MIT
#include "simulation/freezing/waker.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/freezing/tolerances.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

bool Waker::begin()
{
    if (world_.motion.duration() == 0 || phase_ != Phase::filling)
    {
        return false;
    }
    phase_ = Phase::moving;
    lookedAt_ = directionsAtCorners();
    world_.motionStart = world_.clock.time;
    return true;
}

bool Waker::wakeAgain()
{
    if (isMoving() && timeIsUp())
    {
        if (looks_++ < kMaxLooks)
        {
            wake(); // by the pull as it stays, whatever was looked at before
        }
        if (world_.spheres.running().size() == 0)
        {
            phase_ = Phase::over;
        }
    }
    return isMoving();
}

bool Waker::stop()
{
    if (phase_ != Phase::moving || !timeIsUp())
    {
        return false;
    }
    phase_ = Phase::stopped;
    return true;
}

std::array<Eigen::Vector3d, 8> Waker::directionsAtCorners() const
{
    std::array<Eigen::Vector3d, 8> directions;
    for (std::size_t corner = 0; corner < directions.size(); ++corner)
    {
        const auto which = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        directions[corner] = world_.pull.direction(world_.surface.box().corner(which));
    }
    return directions;
}

bool Waker::wakeWhenDue()
{
    if (!isMoving())
    {
        return false;
    }
    const std::array<Eigen::Vector3d, 8> now = directionsAtCorners();
    double change = 0;
    for (std::size_t corner = 0; corner < now.size(); ++corner)
    {
        change = std::max(change, (now[corner] - lookedAt_[corner]).norm());
    }
    return change > kSameDirection && wake();
}

// Looks at all spheres at rest, then again at those that one let go may have carried.
bool Waker::wake()
{
    lookedAt_ = directionsAtCorners();
    std::vector<std::uint32_t> toLookAt;
    for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
    {
        if (!world_.spheres.isRunning(id))
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
            if (world_.spheres.isRunning(id) || isSupported(id))
            {
                continue;
            }
            any = true;
            world_.spheres.wake(id);
            findTouching(id, next);
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        toLookAt = std::move(next);
    }
    return any;
}

void Waker::findTouching(std::uint32_t id, std::vector<std::uint32_t>& found) const
{
    const Eigen::Vector3d place = world_.spheres.position(id);
    const double radius = world_.spheres.radius(id);
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(
        place, radius + 1 + kCarryingGap,
        [&](std::uint32_t row)
        {
            const Ball& near = resting[row];
            if (isWithin(near.position(), place, radius + near.radius + kCarryingGap))
            {
                found.push_back(resting.id(row));
            }
        });
}

bool Waker::isSupported(std::uint32_t id)
{
    const Eigen::Vector3d place = world_.spheres.position(id);
    const double radius = world_.spheres.radius(id);
    const double gap = kCarryingGap * radius;
    normals_.clear();
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(place, radius + 1 + gap,
                        [&](std::uint32_t row)
                        {
                            const Ball& near = resting[row];
                            const auto contact =
                                sphereContact(place - near.position(), radius + near.radius, gap);
                            if (row != world_.spheres.row(id) && contact)
                            {
                                normals_.push_back(contact->normal);
                            }
                        });
    for (const std::uint32_t t : world_.triangles.near(place, radius + gap, nearby_))
    {
        if (const auto contact = frontContact(world_.surface, t, place, radius, gap))
        {
            addNormal(normals_, contact->normal);
        }
    }
    return isCarried(world_.pull.direction(place), normals_, kCarried);
}

} // namespace frostfill
