// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The tolerances of reach. Every one of them errs on the side of "can be reached". [r] is the run's
// unit of length.

/// tau, by which a running sphere may overlap what is at rest. [smallest radius] A hundred times
/// what the engine leaves. Larger: fewer cubes are closed. Smaller: a centre may be in a closed
/// one.
inline constexpr double kOverlap = 1e-5;
/// Gaps up to this count as contacts, as they do for the judge. [r] Larger: less is discarded.
/// Smaller: what is discarded may count one contact more.
inline constexpr double kDiscardGap = 0.01;

/// Edge of a cube. [smallest radius] Larger: parts of an object are found less exactly, and more
/// cubes of a pile have to be searched. Smaller: time and memory with the inverse cube.
inline constexpr double kReachVoxel = 0.6;
/// Edge of a cube at most, as a share of R'. Beyond it a surface may leak: see OpenCubes, 3.
inline constexpr double kLargestVoxel = 0.7;
/// The smallest sphere of a size curve up to which nothing is discarded: it passes between three of
/// the largest that touch, 2 / sqrt(3) - 1. [largest radius] Larger: what is out of reach is not
/// told. Smaller: time for looks that discard nothing.
inline constexpr double kPassesBetween = 0.1547;
/// Marks of a run at which discards are told; see Discards. Larger: time for pictures. Smaller:
/// pictures jump.
inline constexpr std::size_t kMarks = 50;

/// A part that takes less of its box than this is the edges of an object, which are too narrow for
/// a sphere all along. Larger: slender parts are not reported. Smaller: every object has a part.
inline constexpr double kShareOfBox = 0.05;

} // namespace frostfill
