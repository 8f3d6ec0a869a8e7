// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The tolerances of contact between running spheres. [r] is the run's unit of length, [own radius]
// the radius of the sphere that moves. Found by trial on the four objects: a pile of thousands must
// come to rest in time and must not gain energy.

// Broad phase.

/// Gap up to which two runners are a pair, because they may touch within the step. [r] A step is at
/// most 0.33 sqrt(r/g) long. Larger: more pairs to look at. Smaller: fast spheres overlap first.
inline constexpr double kPairMargin = 0.3;
/// That step [sqrt(r/g)]. Where small spheres make steps shorter, the gap is as much smaller.
inline constexpr double kLongestOfMargin = 0.33;
/// Runners up to which all pairs are looked at, which is faster than cells for so few.
inline constexpr std::size_t kFewRunners = 64;
/// So much larger are slabs than what pairs need, so that no rounding puts a pair into slabs that
/// are no neighbours. [1]
inline constexpr double kBeyondRounding = 1 + 1e-9;

// Slabs of a crowd.

/// Members for each slab at least. Larger: small crowds are left to one thread. Smaller: threads
/// wait for each other, and a pile passes the reaction of its floor through more borders.
inline constexpr std::size_t kFewestInSlab = 128;
/// Slabs at least: fewer occupy one thread most of the time. Such a crowd is left whole.
inline constexpr std::size_t kFewestSlabs = 4;

// Position solver.

/// Longest push in one sweep. [own radius] Larger: spheres jump over their neighbours. Smaller:
/// deep overlaps, as of spheres released into one another, take more sweeps.
inline constexpr double kLongestPush = 0.2;
/// Penetration depth from which one sphere climbs another. [own radius] Larger: rows pressed into a
/// corner stay there. Smaller: piles swell.
inline constexpr double kDeep = 0.1;
/// Penetration depth that is left to those taken apart to be frozen. [r] Larger: what is frozen
/// overlaps. Smaller: more sweeps.
inline constexpr double kApart = 1e-8;
/// Sweeps at most that take spheres apart. Piles need a few hundred; what is wedged never ends.
inline constexpr int kMaxSeparations = 1000;

// Velocity solver.

/// Rounds over all contacts in a step. Each carries the floor's reaction up by a layer and more.
/// Larger: time. Smaller: high piles sag.
inline constexpr int kRounds = 8;
/// Gap that an approach may close within a step: beyond it a pair is no contact yet. [r] Larger:
/// spheres that would miss each other brake. Smaller: they overlap first.
inline constexpr double kSoon = 0.05;
/// Approach that is left to spheres that lie on others. [sqrt(g r)] Larger: piles creep. Smaller:
/// rounds are spent on invisible overlaps.
inline constexpr double kSlow = 1e-3;

} // namespace frostfill
