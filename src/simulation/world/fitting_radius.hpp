// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// See Simulation::radiusThatFits. [mesh unit]
[[nodiscard]] double radiusThatFits(const World& world, std::size_t count);

} // namespace frostfill
