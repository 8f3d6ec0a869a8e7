// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The numbers by which spheres are put to sleep and woken. Where no source is named, the value was
/// chosen from runs: the stress matrix of the tests and the figure `error` tell
/// when one is wrong. r is the radius of the sphere that the sentence is about; a window is the
/// time over which a sphere is watched (see engine/tolerances.hpp).
namespace frostfill
{

// When a sphere is sleepy.

/// A calm sphere moves less than this in a window [r]. Larger: a sphere that is about to roll off
/// is caught on its way. Smaller: the solver's own jitter keeps piles awake, and they freeze late.
inline constexpr double kStill = 0.03;
/// Gap below which a contact carries, for the first look at a sleepy sphere [r]. It is twice that
/// of an island (kCarryingGap), because a sphere that passes is then taken down to its contacts
/// exactly, while an island freezes where it lies. Larger: spheres are looked at in vain. Smaller:
/// what hovers by the solver's tolerance waits.
inline constexpr double kSleepyGap = 0.01;
/// Share of the weight that may be missing at that first look [1]. Drop-and-roll has the last word
/// on what carries, so this only saves work. Larger: more searches that fail. Smaller: a sphere in
/// a groove, one contact of which is a hair too far, is not looked at.
inline constexpr double kMostlyUncarried = 0.5;
/// A sphere that is frozen comes down by less than this [r]. Larger: it visibly jumps as it
/// freezes. Smaller: it waits for its neighbours to settle first, and stirs them.
inline constexpr double kLongestSettling = 0.15;

// How long a sphere that cannot be frozen waits, in windows in which it was calm.

/// After which those in a pile freeze together. Larger: piles take longer to come to rest. Smaller:
/// a pile freezes before it has settled, less densely.
inline constexpr std::uint32_t kStillInPile = 4;
/// After which a sphere stops giving way to others, so that it comes down to something at rest.
/// Larger: it is pushed about longer. Smaller: it pushes others about.
inline constexpr std::uint32_t kPatience = 8;
/// Where spheres roll, one that goes farther in a window gives way again, or one that has stood for
/// long and then falls would strike others as if nothing could stop it [r]. Larger: it does. Much
/// smaller: spheres that creep give way to one another forever.
inline constexpr double kYieldsAgain = 1;
/// After which runners are moved far out of a sphere's place (kFarRoom). Larger: freezing takes
/// longer. Smaller: runners jump where a little patience would do.
inline constexpr std::uint32_t kBlocked = 24;
/// After which they have to appear elsewhere. Three times kBlocked: the last resort but one.
inline constexpr std::uint32_t kBlockedForGood = 72;

// How runners make room.

/// That a runner may be moved out of a freezing sphere's place [its r]. Larger: jumps that one
/// sees. Smaller: what lies tightly beside one another blocks one another.
inline constexpr double kNearRoom = 0.1;
/// The same for one that has been blocking for long, or that an overdue sphere needs away.
inline constexpr double kFarRoom = 1;
/// Moves out of an overlap at most. In a narrow wedge between a wall and a sphere each gains
/// little. Smaller: a sphere that is not moved out of one blocks the one below it, and all that lie
/// on them, until they are overdue. Larger: time, where there is no way out.
inline constexpr int kMovesOutOfWedge = 1000;

// Sets.

/// Share of a set that may run when the next one appears [1]. Larger: more run at once, which looks
/// livelier and costs more a step. Smaller: the last stragglers hold up the next set.
inline constexpr double kStillRunning = 0.2;
/// Share of a set that is calm when it freezes whole [1]. Larger: one rattling sphere keeps the set
/// awake. Smaller: it freezes while much of it still moves.
inline constexpr double kStillShare = 0.75;
/// Windows for which it is to stay so. Larger: sets take longer. Smaller: less dense packings, as
/// piles creep for long.
inline constexpr std::uint32_t kStillSet = 30;
/// Windows between two searches for what is to complete such a set: as long as a sphere takes to
/// fall out of the band in which spheres appear. Smaller: searches in vain. Larger: sets take
/// longer to fill.
inline constexpr std::uint32_t kWindowsToFall = 9;

// Waking. Which contacts hold a sphere at rest, and which share of the pull they may leave, stands
// with the other tolerances of contact: kCarryingGap and kCarried in contact/tolerances.hpp.

/// Times that unsupported spheres are woken after the object has stopped. Larger: a sphere that is
/// frozen without support each time, for want of room, runs in vain for longer. Smaller: what the
/// last ones carried is left hanging.
inline constexpr int kMaxLooks = 10;
/// Change of the pull's direction that is not worth a look at all spheres at rest [1]. Larger: what
/// a slow motion lets go wakes late, several layers at once. Smaller: time.
inline constexpr double kSameDirection = 0.005;

} // namespace frostfill
