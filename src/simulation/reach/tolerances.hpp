// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The tolerances of reach. Every one of them errs on the side of "can be reached", so a wrong one
// costs time or keeps what could be dropped, but never changes a result. The margins of the map are
// settings of its own: ReachMap::Margins. [r] is the run's unit of length.

/// Above the rounding of any coordinate. [r] Larger: fewer cubes are blocked. Smaller: rounding may
/// block a cube in which a sphere can be.
inline constexpr double kReachRounding = 1e-9;

// Cubes.

/// Edge of a cube at most, as a share of R'. Beyond it a surface may leak: see ReachMap, 3.
inline constexpr double kLargestVoxel = 0.7;
/// Sets of cubes that are kept in memory, here and in the flood.
inline constexpr int kSetsOfCubes = 4;
/// Sets of a whole grid up to which it has no bricks. Larger: memory for cubes without anything.
/// Smaller: ordinary objects look up bricks. [bytes]
inline constexpr std::size_t kWholeGrid = std::size_t{32} << 20;
/// Where memory is short, cubes grow by this factor until they fit. Larger: cubes larger than
/// needed. Smaller: more tries.
inline constexpr double kGrowth = 1.02;
/// And by this one where even the largest cubes allowed are reached at once, so that it ends.
inline constexpr double kMinGrowth = 1.0001;
/// How often ClearSearch halves a cube, an even number: parts that small count as clear. Larger:
/// eight times the time for each, for hardly a cube more. Smaller: more is kept.
inline constexpr int kHalvings = 2;

// What `frostfill mesh --radius` reports.

/// Edge of a cube. [r] Larger: parts are found less exactly. Smaller: time and memory.
inline constexpr double kInspectionVoxel = 0.6;
/// A part that takes less of its box than this is the edges of an object, which are too narrow for
/// a sphere all along. Larger: slender parts are not reported. Smaller: every object has a part.
inline constexpr double kShareOfBox = 0.05;

} // namespace frostfill
