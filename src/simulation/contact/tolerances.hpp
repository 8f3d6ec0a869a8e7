// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

// The tolerances of contact that several rooms share. [r] is the run's unit of length, the radius
// of its largest sphere; [own radius] is that of the sphere in question. The values were found by
// trial on the four objects unless a source is given.

// Touching. A sphere moves until a gap of kReached is left, so a contact acts from a little farther
// away (kTouch), and what carries a sphere at rest may be farther away still (kCarryingGap).

/// A wall counts as reached when the gap is below this. [r] The rounding of a coordinate a thousand
/// radii from the origin is 1e-13. Larger: spheres stop visibly short of walls. Smaller: Newton's
/// steps are spent on rounding.
inline constexpr double kReached = 1e-10;
/// Gap up to which a contact acts on a sphere that moves. [r] Larger: spheres are stopped by what
/// they do not touch, and slide around corners before they reach them. Smaller: rounding hides a
/// contact, and a sphere at rest trembles.
inline constexpr double kTouch = 1e-7;

/// Gap up to which spheres carry each other: runners in a pile that freezes together, and spheres
/// at rest that are asked whether they have to wake. [own radius] These two are one: with a smaller
/// gap for waking, what a pile froze on woke, froze again, and so on without end. The position
/// solver leaves overlaps and gaps of a thousandth. Half of what the judge of a state allows
/// (0.01), so that what is frozen on this ground passes. Larger: spheres hang in the air. Smaller:
/// piles never freeze together.
inline constexpr double kCarryingGap = 0.005;

/// By how much a place found is clear of everything, and by how much farther than an answer has
/// looked its box reaches. [r] Larger: spheres lose their contacts when they are moved. Smaller:
/// rounding may overlap them, or hide that an answer has changed.
inline constexpr double kClearance = 1e-9;

// Carrying: the share of the weight that a sphere's contacts may leave. It grows from kSettled,
// with which a sphere is frozen, over kCarried, with which it stays at rest, to the 0.1 of the
// judge of a finished state, who has his own. Were they one, rounding could wake what has just been
// frozen.

/// Share that may remain where drop-and-roll ends. Larger: spheres stop on slopes. Smaller: the
/// ends of curves, where the pull fades with the distance, take many more steps.
inline constexpr double kSettled = 0.01;

/// Share that may remain in a pile, and for one at rest. Larger: spheres rest on steep contacts.
/// Smaller: piles never freeze together, and wake without a cause.
inline constexpr double kCarried = 0.05;

// Directions.

/// A direction that leads into a contact by less than this slides along it: a sine. Larger: a
/// sphere enters what it slides along. Smaller: rounding stops a sphere in mid-slide.
inline constexpr double kSlides = 1e-7;

/// Depth in a wall from which a sphere that moves is taken back to its surface. [own radius] What
/// slides may lead into a wall by kSlides, and runners that push each other along a wall add that
/// up step by step. Larger: the overlaps with walls that remain. Smaller: more positions are
/// corrected, each of which may press a sphere into another by as much.
inline constexpr double kCrept = 5e-8;

/// One minus the cosine up to which a plane's normal and the direction from the closest point
/// agree. Larger: the edge between two triangles of a plane acts as a second contact. Smaller:
/// rounding hides the plane itself.
inline constexpr double kBelow = 1e-13;

/// One minus the cosine up to which two normals are the same: an angle of 1.4e-7. Larger: contacts
/// of a narrow wedge are taken for one. Smaller: the corners of many triangles fill the list, and
/// the cone of the contacts takes time with the square of its length.
inline constexpr double kSameNormal = 1e-14;

/// Along a plane a direction may lead into the next triangle of the plane by this sine: the bend up
/// to which two triangles are one plane (kFlatBend), which their contacts do not tell apart
/// (kSameNormal). Larger: spheres enter the next triangle. Smaller: a cast stops at a bend that
/// gives no contact, and the sphere hangs there.
inline constexpr double kSlidesAlongPlane = 1.5e-7;

/// A direction may lead into a contact of the cone by this share of its length, which is rounding.
/// Larger: what slides creeps into walls. Smaller: a direction along two contacts seems to lead
/// into one of them, and the sphere sticks.
inline constexpr double kLeadsInto = 1e-10;

/// Two contacts whose normals' cross product is shorter than this act as one: the line between them
/// would be rounding. Larger: a narrow wedge lets its sphere out at the wrong end. Smaller: it
/// leads anywhere.
inline constexpr double kParallel = 1e-9;

// Sphere cast.

/// Newton's steps at most. The method converges quadratically; more steps than this mean a grazing
/// approach. Smaller: spheres stop before they touch. Larger: time.
inline constexpr int kNewtonSteps = 40;

} // namespace frostfill
