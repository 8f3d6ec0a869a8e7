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

} // namespace frostfill
