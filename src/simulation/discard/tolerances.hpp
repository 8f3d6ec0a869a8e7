// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/reach/reach_map.hpp"

#include <array>
#include <cstddef>

// The numbers of the exact discard. The margins decide what is safe, the rest only how early and at
// what price something is dropped. The figure `error` shows that price.

namespace frostfill
{

/// How far a centre may be inside an overlap, move in a step, and be off for rounding, in the units
/// of ReachMap::Margins, overlap and step in smallest radii. The second replaces the first when a
/// guard has tripped; after the last, nothing is dropped any more. The engine never moves a sphere
/// but along swept paths, and its overlaps with what is at rest are rounding: the first are a
/// thousand times what it needs. Smaller: guards trip, and everything dropped comes back. Larger:
/// less is dropped.
inline constexpr std::array<ReachMap::Margins, 2> kReachMargins = {
    ReachMap::Margins{1e-3, 0, 0.02},
    ReachMap::Margins{0.05, 0.5, 0.3},
};

/// Edge of the map's cubes [smallest radius]. Larger: a surface leaks from 0.7 on, so nothing is
/// ever out of reach. Smaller: time and memory with the inverse cube, and, as parts of cubes are
/// looked at where they decide, hardly more is dropped.
inline constexpr double kReachVoxel = 0.69;

/// The smallest sphere of a size curve up to which nothing is discarded: it passes between three of
/// the largest that touch, 2 / sqrt(3) - 1. [largest radius] Larger: what is out of reach is
/// tested. Smaller: time for looks that drop nothing.
inline constexpr double kPassesBetween = 0.1547;

/// Updates in a run about; each looks at a share of all spheres that come to rest. An update costs
/// a few ns for each sphere and polygon that is kept. Larger: time. Smaller: what is out of reach
/// is tested for longer, and pictures jump when it goes.
inline constexpr std::size_t kUpdates = 50;

/// Polygons that look for a witness together, where they are small enough. Larger: fewer are near
/// the same cubes. Smaller: more of them ask for the same.
inline constexpr std::size_t kPolygonsTogether = 16;

/// The share of what fits that has come to rest when a run until full is nearly at its end. From
/// then on cubes are halved more often: otherwise much is kept that only the last sphere's rest
/// decides, and the last picture jumps. Larger: too few pictures are left. Smaller: time.
inline constexpr double kNearlyFull = 0.8;
inline constexpr int kHalvingsWhenNearlyFull = 6;

} // namespace frostfill
