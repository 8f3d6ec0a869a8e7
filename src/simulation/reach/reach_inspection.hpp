// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// See inspectReach: of a run's object and its smallest radius, with the searches that it has
/// anyway.
[[nodiscard]] ReachInspection inspectReach(const World& world, std::size_t bytes);

} // namespace frostfill
