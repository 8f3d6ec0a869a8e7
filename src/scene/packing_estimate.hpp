// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

// Equal spheres of radius r that fill an object of volume V and surface S take about
// phi (V - c r S): random packing far from walls takes the share phi of the room, and a wall takes
// away a layer of c radii. Both are fitted to dropped, frictionless fillings of several shapes.
inline constexpr double kPackingFraction = 0.586; ///< phi
inline constexpr double kWallLayer = 0.38;        ///< c

} // namespace frostfill
