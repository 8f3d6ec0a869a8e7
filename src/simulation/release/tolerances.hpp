// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// The numbers by which places for spheres are found. They decide how fast an object fills and how
// full, never whether a place is clear: that depenetrate() does, exactly. Values by trial on the
// four objects.

namespace frostfill
{

/// Edge of a cell of the lattice of sites [radius of its class]. Larger: a place in a cell that no
/// push from the site reaches is missed, and "full" comes too early. Smaller: memory and time with
/// the inverse cube.
inline constexpr double kSiteCell = 0.5;
/// Sites at most, whose numbers fit 32 bits; beyond it cells are larger. Not to be increased.
inline constexpr double kMaxSites = 4e9;
/// Below the highest ceiling, in which falls begin [r]. Larger: spheres appear in sight, lower
/// down. Smaller: fewer find room at once.
inline constexpr double kTopBand = 4;
/// Places in a row that others run through, after which a search gives up for now [1]: most do.
/// Larger: time, when the object is crowded. Smaller: sets appear with fewer spheres than they
/// could.
inline constexpr int kMaxMisses = 64;
/// Draws of a batch: ceilings at which nothing fits go at its end. [1] Results depend on it.
/// Larger: draws that lead nowhere, once few ceilings are left. Smaller: threads have too little to
/// do at once.
inline constexpr std::uint64_t kBatch = 256;
/// Places in a row that are looked for ahead of their time, on all threads. The answer is the same
/// for any. Larger: more of them are void when something comes to rest. Smaller: threads wait for
/// each other.
inline constexpr std::size_t kDrawsAhead = 64;
/// Classes of radii at most, each of which has sites of its own. Larger: memory. Smaller: a radius
/// is released only where a much larger one fits, and the object is not as full.
inline constexpr std::size_t kMaxClasses = 8;
/// Ratio of the largest to the smallest radius of a class [1], unless that makes too many classes.
/// Larger and smaller as above.
inline constexpr double kWidestClass = 1.1;

/// Which of the random numbers of a draw the radius takes; 0 to 2 are those of the sites.
inline constexpr std::uint64_t kRadiusDraw = 3;

/// Sites of small spheres of a size curve are as for this radius. [largest radius] Larger: the
/// first layers of spheres begin farther from walls. Smaller: time and memory for sites.
inline constexpr double kCoarsestSites = 0.35;
/// Radii in a row that a size curve cannot bear, after which it cannot be kept. [1] Larger: time,
/// at the end. Smaller: a radius that could still be added is missed.
inline constexpr int kMaxDrawsOfCurve = 256;
/// Which of the random numbers of a draw says where among all sites a gap is looked for.
inline constexpr std::uint64_t kGapDraw = 4;

// Inlets.

/// Places in a row that are taken, after which there is no room in the inlets for now. Larger:
/// time. Smaller: a heap that has all but reached them ends the run.
inline constexpr int kMaxMissesInInlets = 256;
/// How far a place may be moved out of an overlap. [own radius] Larger: spheres appear beside the
/// opening. Smaller: places are missed.
inline constexpr double kOffInInlet = 0.01;

} // namespace frostfill
