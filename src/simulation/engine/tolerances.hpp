// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The numbers of the engines' schedules. Where no source is named, the value was chosen from runs:
/// The stress matrix of the tests and frostfill-lab tell when one is wrong. r is the largest radius
/// of the run and g gravity, the units of length and acceleration.
namespace frostfill
{

// Time.

/// Default time step [sqrt(r/g) of the smallest sphere]. Larger: contacts between running spheres
/// are resolved less well, and spheres visibly press into one another. Smaller: time.
inline constexpr double kStep = 0.165;
/// The same with Motion::skip, where nothing falls from far and so nothing is fast. A longer step
/// that the user asks for is divided: gravity alone would make spheres in contact too fast to come
/// to rest.
inline constexpr double kSkipStep = 0.33;
/// So much longer at most are steps of a size curve then, as for a sphere of the mean volume: most
/// are not the smallest. [1] Larger: small ones that run press into one another for longer.
inline constexpr double kLongerForSizes = 2;
/// The shortest step that may be asked for [sqrt(r/g) of the smallest]. Smaller: runs of which
/// it seems not to end. Larger: a study of ever shorter steps has to stop early.
inline constexpr double kShortestStep = 1e-6;
/// The window over which a sphere is watched [sqrt(r/g)]. Larger: spheres freeze later. Smaller: a
/// sphere at the top of its bounce seems calm.
inline constexpr double kWindow = 0.33;

// When a sphere is overdue, and is frozen wherever it gets.

/// The largest restitution that is given the time to come to rest [1]. With 1 none would be enough.
inline constexpr double kLiveliest = 0.95;
/// Falls through the height that a sphere is given at least. Smaller: spheres are overdue on a long
/// way down. Larger: what never comes to rest runs longer.
inline constexpr double kMinFalls = 4;

// When a run is stopped.

/// How much faster than a fall through the whole object a sphere is before it cannot be right [1].
/// Larger: an explosion is seen later. Smaller: a small sphere that large ones hit counts as one.
inline constexpr double kTooFast = 10;
/// Steps between two looks whether running spheres are outside of the object, in its box. Larger:
/// one that has left it runs on for longer. Smaller: time.
inline constexpr std::uint64_t kStepsPerSide = 64;

// Sweeps.

/// Sweeps of the solver at least, where whole piles run at once as the object moves. Smaller: deep
/// piles are squeezed. Larger: time.
inline constexpr int kSweepsInAvalanche = 40;

// Pouring grains (Motion::granular).

/// Grains are looked at, and more may appear, after this time [sqrt(r/g)]. A picture may show it.
/// Larger: grains that appear leave gaps in what falls. Smaller: time.
inline constexpr double kTimeOfPour = 0.1;
/// All that has been poured in rests, but for few that creep, when no grain is faster than this
/// [sqrt(g r)], though the last ones have had this time to begin to fall [sqrt(r/g)].
inline constexpr double kSpeedOfPour = 0.5;
inline constexpr double kTimeToFall = 2;
/// Pouring is over in any case when none has appeared for so long [sqrt(r/g)].
inline constexpr double kLongestPour = 400;
/// The same where collisions lose nothing, in falls through the object: such grains never grow
/// calm, and settling takes their speed away. Larger: time, at each time that room is left.
inline constexpr double kElasticFalls = 4;
/// Where a packing fraction of the bulk is asked for, grains sink with a drag of all motion
/// [1/sqrt(r/g)], so at a tenth of sqrt(g r) in the end: they come in as loosely as they can, as
/// nothing loosens them. Larger: time. Smaller: denser, such as 0.601 without drag and 0.575 at 10,
/// beyond ten radii from walls, with friction 1 and 2,200 spheres in the cube.
inline constexpr double kDragOfLoosePour = 10;

// Where spheres appear.

/// A sphere that the user places in a wall is moved by less [r]. Larger: spheres end up far from
/// where they were put. Smaller: places are refused that a small correction would mend.
inline constexpr double kFarRelease = 4;

// Without dynamics (Motion::descend).

/// Spheres for each thread that come down ahead of their time. The answer is the same for any.
/// Larger: more of them are void because one before them has come to rest in their way. Smaller:
/// threads wait for each other.
inline constexpr std::size_t kAheadOfThread = 8;
/// A run is recorded as at most so many sets. Larger: more pictures than anyone looks at.
inline constexpr std::size_t kMaxSets = 200;

} // namespace frostfill
