// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <cstdint>

namespace frostfill
{

/// Contacts of a sphere: other spheres at rest whose gap to it is below kContactGap of its own
/// radius, and pieces of wall at most as far away. Triangles that hang together at edges which are
/// as near are one piece, so that the count does not depend on how finely a wall is divided. A wall
/// through the centre does not count. Of a running sphere: 0.
[[nodiscard]] std::uint32_t restingContacts(const World& world, std::uint32_t id);

} // namespace frostfill
