// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

// The tolerances of motion among what is at rest. [r] is the run's unit of length, [own radius] the
// radius of the sphere that moves. Found by trial on the four objects unless a source is given.

// Free flight.

/// A displacement [r], and a share of a step's time, that are not worth following. Larger: slow
/// spheres stop on slopes. Smaller: rounding gives directions, and adds parts to a path.
inline constexpr double kNegligible = 1e-12;

/// Parts of one step's path, besides those that a long path needs anyway: it ends there if it still
/// meets contacts. Larger: spheres that rattle in a wedge take their time. Smaller: spheres lose
/// time of flight, and so energy.
inline constexpr int kMaxParts = 12;
/// Straight parts of one displacement by the position solver, for the same reason.
inline constexpr int kMaxShifts = 3;
/// Share of the skin of a neighbour list that a renewed list has ahead of it; the rest is left for
/// the next step. Larger: lists are renewed in every step. Smaller: in several parts of one.
inline constexpr double kShareOfSkin = 0.5;
/// A part of a path that leaves the neighbour list is shortened to this share of what would reach
/// its edge, because the path is a parabola and not linear in time. Larger: more tries. Smaller:
/// shorter parts.
inline constexpr double kIntoTheList = 0.95;
/// But by no more than to this share of its time, so that one try makes some way. Larger: more
/// tries where spheres are fast.
inline constexpr double kShortestTry = 0.1;

/// What is slower stands still, as rounding leaves a sphere that rolling friction has stopped.
/// [sqrt(g r)] Larger: what begins to roll is stopped. Smaller: it goes to and fro.
inline constexpr double kStandsStill = 1e-9;

// Drop and roll.

/// Straight part of a path that follows a curve. [own radius] Larger: the path leaves the curve,
/// and the contact is lost. Smaller: more steps.
inline constexpr double kLongestSlide = 0.3;
/// A path that advances by less is stuck. [own radius] Larger: spheres give up on the way. Smaller:
/// wedges, which are entered ever more slowly, take many more steps.
inline constexpr double kShortestSlide = 1e-4;
/// A neighbour list that reaches less far is renewed. [r] Larger: lists are renewed too often.
/// Smaller: slides end at the list's edge.
inline constexpr double kShortestLook = 0.1;
/// How far behind a straight part the contact may be that curves away from it. [own radius] More
/// than the part's square. Larger: another contact is taken for it. Smaller: it is lost.
inline constexpr double kRegain = 0.2;
/// Near the bottom of a curve the pull fades with the distance to it: a part is at most so many
/// times that distance long. From 2 on the path swings from side to side; 1 creeps to the bottom.
inline constexpr double kBeyondTheBottom = 1.5;
/// Steps of a path at most, for each radius of the object's height and ten more. A path loses
/// height in each, so it ends by itself except in wedges. Smaller: long slides are given up.
inline constexpr double kStepsPerRadiusOfHeight = 200;

} // namespace frostfill
