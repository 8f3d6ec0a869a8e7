// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The numbers of the judge. [r] is the run's unit of length.

/// A gap below it counts as a contact. [own radius] Larger: neighbours count that carry nothing.
/// Smaller: contacts are lost to the tolerances of the solvers.
inline constexpr double kContactGap = 0.01;
/// A centre that is no farther from a wall lies on it, but for rounding. [r] Larger: walls beside a
/// centre are missed. Smaller: a wall through a centre counts with a direction that is rounding.
inline constexpr double kOnWall = 1e-12;
/// Cosine of the angle from which two walls push in the same direction. Smaller: one of two walls
/// that meet in a very flat edge is missed. Larger: a wall of many triangles counts many times.
inline constexpr double kSameWall = 1 - 1e-12;

/// Share of its weight that the contacts of a supported sphere may leave, all others being held.
/// Larger: what begins to fall counts as supported. Smaller: what hovers by the solvers' tolerances
/// does not.
inline constexpr double kUnsupported = 0.1;

// The slope of a heap. Its top is round, and its foot thins out, so both are left out.

/// Sectors of a ring. Larger: a sector of a small ring holds no sphere. Smaller: the highest of
/// more spheres counts, and the heap seems higher.
inline constexpr std::size_t kSectorsOfHeap = 16;
/// Share of the spheres within the heap's radius. Larger: what has rolled away belongs to it.
inline constexpr double kInHeap = 0.95;
/// Rings that count, in radii of the heap.
inline constexpr double kNearestRing = 0.2;
inline constexpr double kFarthestRing = 0.8;
inline constexpr std::size_t kFewestRings = 4;

// Whether all that is at rest stays so together. How much of its weight may be missing on a
// balanced sphere is the scene's: see JudgeSettings.

/// Share of the spheres that may be unbalanced in a packing that stands. Larger: a part of it may
/// fall. Smaller: one sphere that hangs on a friction of its own decides for thousands.
inline constexpr double kLoose = 0.01;
/// To which share of itself, or of a tenth, the least friction is found. Smaller: time.
inline constexpr double kFrictionStep = 0.01;
/// Forces are found when no step changes an acceleration by more of what may be missing. Larger:
/// forces that have not yet spread to the foot of a pile. Smaller: time.
inline constexpr double kSettledForces = 0.01;
/// Steps after which forces that go on changing are taken as they are: near the least friction
/// there is always a step to go. Smaller: high piles are said to fall. Larger: time.
inline constexpr int kMostForceSteps = 2000;
/// Steps between two looks at how well the spheres are balanced. Larger: steps in vain. Smaller:
/// time for looks.
inline constexpr int kLookEvery = 20;

// The search for the least friction gives up a friction before forces have settled when, after so
// many looks, so many times more spheres are unbalanced than may be, and the share of them that
// there were after half the looks. On piles of 2,000 and 20,000 spheres the answer is the same as
// without, in two thirds of the time.

inline constexpr std::size_t kFewestLooks = 20;
inline constexpr double kFarTooMany = 4;
inline constexpr double kHardlyFewer = 0.8;

} // namespace frostfill
