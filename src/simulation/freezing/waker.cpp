// SPDX-License-Identifier: MIT
#include "simulation/freezing/waker.hpp"

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
    support_.wakeUncarried(
        std::move(toLookAt), [](std::uint32_t) { return true; },
        [&](std::uint32_t id)
        {
            any = true;
            world_.spheres.wake(id);
        });
    return any;
}

} // namespace frostfill
