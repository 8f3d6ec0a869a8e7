// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// Examines every sphere of the world as it stands. O(#S) but for the winding numbers.
[[nodiscard]] QualityReport examine(const World& world);

} // namespace frostfill
