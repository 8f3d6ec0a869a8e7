// SPDX-License-Identifier: MIT
#include "simulation/motion/rolling.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/motion/tolerances.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kShareThatRolls = 5.0 / 7; // of a force, moves a full sphere along

} // namespace

RollingLaw RollingLaw::of(const Scene& scene)
{
    const RestSettings& rest = scene.rest;
    const bool sizes =
        scene.spheres.sizes.curve || (scene.spheres.radius && !scene.spheres.radius->equal());
    if (sizes)
    {
        return {};
    }
    return {std::min(rest.friction, rest.wallFriction.value_or(rest.friction)),
            rest.rollingFriction};
}

Rolling rollAlong(const RollingLaw& law, const Eigen::Vector3d& velocity,
                  const Eigen::Vector3d& pull, std::span<const Eigen::Vector3d> normals,
                  double lever)
{
    const Eigen::Vector3d along = projectToFree(pull, normals);
    const Eigen::Vector3d pressed = pull - along;
    const double push = pressed.norm();
    const double resists = law.resistance * lever * push;
    const double grips = law.friction * push;
    const double speed = velocity.norm();
    Rolling rolling;
    if (speed < kStandsStill && along.norm() <= std::min(resists, grips))
    {
        rolling.pull = pressed;
        rolling.stands = true;
        return rolling;
    }
    const Eigen::Vector3d direction =
        speed < kStandsStill ? along.stableNormalized() : velocity / speed;
    Eigen::Vector3d gains = kShareThatRolls * (along - resists * direction);
    if (const double ahead = along.dot(direction); ahead < 0)
    {
        gains += (1 - kShareThatRolls) * ahead * direction; // as it has no spin to spend
    }
    if ((along - gains).norm() > grips)
    {
        gains = along - grips * direction;
    }
    rolling.pull = pressed + gains;
    const double slows = -gains.dot(direction);
    if (slows > 0)
    {
        rolling.time = speed / slows;
    }
    return rolling;
}

} // namespace frostfill
