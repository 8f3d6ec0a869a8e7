// SPDX-License-Identifier: MIT
#include "simulation/contact/footprint.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

void Footprint::clear()
{
    balls_.clear();
    falls_.clear();
    box_.setEmpty();
}

void Footprint::addBall(const Eigen::Vector3d& centre, double distance)
{
    const double seen = distance + kSeenBeyond;
    balls_.push_back({centre, seen});
    box_.extend(Eigen::Vector3d(centre.array() - (seen + 1)));
    box_.extend(Eigen::Vector3d(centre.array() + (seen + 1)));
}

void Footprint::addFall(const Eigen::Vector3d& from, double radius, double end)
{
    const double seen = end - kSeenBeyond;
    falls_.push_back({from, radius, seen});
    const double reach = radius + 1;
    box_.extend(Eigen::Vector3d(from.x() - reach, seen - reach, from.z() - reach));
    box_.extend(Eigen::Vector3d(from.array() + reach));
}

bool Footprint::meetsParts(const Eigen::Vector3d& centre, double radius) const
{
    const auto isNear = [&](const Ball& ball)
    { return isWithin(centre, ball.centre, ball.distance + radius); };
    // As in a fall: where it would touch the sphere.
    const auto isOnWay = [&](const Fall& fall)
    {
        const double squared = squaredHeightOfTouch(centre - fall.from, fall.radius + radius);
        return squared > 0 && centre.y() < fall.from.y() &&
               centre.y() + std::sqrt(squared) > fall.end;
    };
    return std::any_of(balls_.begin(), balls_.end(), isNear) ||
           std::any_of(falls_.begin(), falls_.end(), isOnWay);
}

} // namespace frostfill
