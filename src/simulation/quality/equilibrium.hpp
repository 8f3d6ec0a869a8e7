// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <vector>

namespace frostfill
{

/// Judges whether all spheres at rest stay so together, under the friction of the scene's judge, or
/// under none if it names none. See JointBalance for the method and its cost.
[[nodiscard]] EquilibriumReport judgeEquilibrium(const World& world);

/// What is missing on each sphere at rest [own weight], by its row there, under the same friction;
/// 0 for less than forces settle to.
[[nodiscard]] std::vector<double> unbalanceAtRest(const World& world);

/// The forces with which spheres at rest hold one another, under the same friction.
struct ContactForces
{
    struct Pair
    {
        std::uint32_t upon; ///< id
        std::uint32_t from;
        Eigen::Vector3d force; ///< [weight of a sphere of mean volume] on `upon`
    };
    std::vector<Pair> pairs;
    double missing = 0; ///< [own weight] on a sphere, at most
};
[[nodiscard]] ContactForces forcesAtRest(const World& world);

} // namespace frostfill
