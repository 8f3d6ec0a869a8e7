// SPDX-License-Identifier: MIT
// Room: the judge of a state: overlaps, support, centres outside, energy. It shares no code with
// what it judges except the closest point.
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// Examines every sphere of the world as it stands. O(#S) but for the winding numbers.
[[nodiscard]] QualityReport examine(const World& world);

} // namespace frostfill
