// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The tolerances of the paper's method. The paper names none of them; these are chosen so that its
// four objects come out clean. [r] is the run's unit of length, [own radius] that of the sphere.

// Algorithm 1.

/// A centre that a step leaves nearer to the surface than this is put back to where it was. [own
/// radius] Larger: spheres in narrow wedges stop. Smaller: the next step may lead through the wall.
inline constexpr double kSmallestDepth = 0.25;
/// A single push off a wall that is not worth that check. [own radius] Larger: a sphere may leak.
/// Smaller: time.
inline constexpr double kShallow = 0.1;
/// Frozen spheres that are tested at once: two registers of four.
inline constexpr std::size_t kBlock = 8;
/// How far from a centre a polygon may be to be looked at again by that check. [own radius] Smaller
/// than kSmallestDepth and what a sphere is pushed in a step: the nearest wall may be missed.
inline constexpr double kNearby = 2;
/// How far from a sphere's surface others' centres may be to be looked at by way of a grid: the
/// largest radius, and as much again for what the spheres before may have pushed. [r] Smaller: the
/// grid and all pairs give different results. Larger: time.
inline constexpr double kGridReach = 2;

// The engine.

/// A centre's polygon may be this far beyond the edge of its quarter: its radius, and what it may
/// be pushed while it is tested. [r] Smaller: walls are missed. Larger: quarters overlap more.
inline constexpr double kQuarterReach = 1.1;
/// Contacts between spheres move a centre at most this far in a step, so that walls can win. [own
/// radius] Larger: crowds press spheres through walls. Smaller: deep overlaps last longer.
inline constexpr double kPaperLongestPush = 0.5;
/// No fall moves a sphere farther than this in a step by default. [smallest radius] Larger: fast
/// spheres pass each other and thin walls. Smaller: more steps.
inline constexpr double kLongestFall = 0.5;
/// Largest default step, which matters for objects not much higher than a sphere. [sqrt(r/g) of the
/// smallest]
inline constexpr double kPaperLongestStep = 0.1;
/// Approaches slower than gravity makes in this many steps do not bounce. Larger: spheres look
/// sticky. Smaller: nothing comes to rest.
inline constexpr double kBounceSteps = 4;
/// A centre this far outside the box has leaked and will never rest. [r] Smaller: one that is about
/// to be pulled back is given up. Larger: a set waits longer for it.
inline constexpr double kLost = 4;
/// Steps of the window in which spheres are watched, at most: it has to fit its counter.
inline constexpr double kLongestWindow = 1e6;

} // namespace frostfill
