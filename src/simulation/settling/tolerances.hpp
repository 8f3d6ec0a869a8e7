// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

#include <cstddef>

namespace frostfill
{

// The numbers of settling together. Units of the run: r, g, and the mass of a sphere of radius 1.
// Where no source is named, the value was found by trial on the four objects, with friction 0, 0.3
// and 0.6.

// Contacts.

/// Stiffness of a contact for each r of the object's height [m g / r^2]: a column of spheres as
/// high as the object presses its lowest one in by a hundredth. Larger: shorter steps. Smaller:
/// what has filled the object is squeezed before it settles.
inline constexpr double kStiffnessOfHeight = 100;
/// Stiffness along a contact over that across it [Silbert et al. 2001].
inline constexpr double kTangentialStiffness = 2.0 / 7;
/// The most damping over the critical one, whatever the restitution [1]: with it, collisions keep
/// 0.34 of their speed. A sphere with twelve contacts is damped by all of them. Larger: explicit
/// steps of this length are not stable.
inline constexpr double kMostDamping = 0.45;
/// A time step over the square root of mass over stiffness. Larger: steps are not stable. Smaller:
/// time.
inline constexpr double kStepOfSettling = 0.2;

// Lists of what may touch.

/// Gap up to which two spheres are listed, or a triangle beside a sphere [r]. Larger: longer lists.
/// Smaller: they are made anew more often.
inline constexpr double kListMargin = 0.1;
/// What is fast is listed as far ahead besides as it goes in so many steps, but at most so far [r].
/// Larger: longer lists. Smaller: while spheres fall, lists are made anew in each step.
inline constexpr double kStepsListed = 12;
inline constexpr double kMostListedAhead = 0.5;
/// Two walls whose normals differ by less than this, one minus the cosine, are one. Normals of one
/// plane differ by 1e-13.
inline constexpr double kOneWall = 1e-9;
/// Cosine from which two walls share a push: 26 degrees. Larger: round walls of many triangles are
/// too stiff for the step. Smaller: a blunt edge pushes as one of its faces would.
inline constexpr double kSharesPush = 0.9;
/// The least share of a wall that has one. Smaller: rounding decides.
inline constexpr double kLeastShare = 1e-3;
/// Cosine from which a contact with a wall goes on in one with another wall. Larger: a sphere that
/// rolls over an edge forgets what friction holds.
inline constexpr double kGoesOn = 0.8;

// Rest.

/// The schedule looks at all after this time [sqrt(r/g)], and a picture may show it.
inline constexpr double kTimeOfLook = 0.5;
/// A sphere moves if more than this is missing on it [own weight], and a loose one if it is faster
/// than this [sqrt(g r)]. Larger: what creeps is taken to rest.
inline constexpr double kMissingOnMoving = SettlingReport::kMissingOnMost;
inline constexpr double kSpeedOfMoving = 2e-3;
/// Share of the spheres that may still move when contacts begin to harden. Larger: drag slows down
/// what still flows. Smaller: everybody waits for few.
inline constexpr double kFewMove = 0.01;
/// After this time contacts harden, whatever moves [sqrt(r/g)]. Without friction a pile sinks for a
/// hundred.
inline constexpr double kLongestFlow = 200;
/// Time t in which an overlap turns into a force [sqrt(r/g)]. Larger: time. Its product with the
/// drag c has to be above 1, or what swings swings ever more: on a spring of frequency w,
/// x''' + c x'' + w^2 x' + w^2 / t x = 0 [Hurwitz 1895].
inline constexpr double kHardening = 0.7;
/// Drag of all motion meanwhile [1/sqrt(r/g)]. Larger: soft piles take longer. Smaller: see above.
inline constexpr double kDrag = 3;
/// The fastest that a sphere becomes meanwhile [sqrt(g r)]. What falls through that drag has a
/// third of it. A row of spheres that is too long for its place, as three across a tube of their
/// diameters, is pressed together ever more until it gives way. Larger: then it bursts. Smaller:
/// time.
inline constexpr double kFastestHardening = 1;
/// Overlap in whose stead a contact holds a force from which friction does not hold it, before
/// contacts grow stiffer [r]: a force as of ten columns as high as the object. Larger: such a row
/// is stuck. Smaller: what lies in a narrow wedge does not come to rest. And the most that it is
/// [this]. Larger: such a row bursts. Smaller: it does not get out where others lie on it.
inline constexpr double kSlipsFrom = 0.1;
inline constexpr double kMostOverSlipping = 100;
/// Overlap from which it is taken away at once [r]. Larger: normals turn by more meanwhile, and
/// forces are out of balance again.
inline constexpr double kOverlapRelieved = 1e-3;
/// Force that is missing on a sphere that creeps [own weight]: where more than kFewMove of them do,
/// overlaps are not yet taken away. Larger: more goes on moving in another program, such as 12 % of
/// 2,000 spheres beyond 0.02 r, not 1 %, at 0.005. Smaller: time.
inline constexpr double kMissingOnCreeping = 0.001;
/// No sphere goes farther meanwhile [r]. Larger: what cannot be taken away moves spheres through
/// walls. Smaller: high piles are lifted by hardening alone.
inline constexpr double kMostRelieved = 0.2;
/// Sweeps for that, at most, and what they may leave [kGapAtRest].
inline constexpr int kSweepsOfRelief = 500;
inline constexpr double kLeftByRelief = 0.1;
/// Each contact is opened by this times what it lacks [1]. Larger: unstable from 2 on. Smaller: a
/// high pile takes more sweeps.
inline constexpr double kOverRelaxation = 1.85;
/// Contacts grow stiffer after the first of these times of hardening [sqrt(r/g)], by the second at
/// each look, until they are so by the third in all. A contact on which a force rests that needs no
/// overlap gives way to the side the more, the softer it is: without friction, what is too soft
/// never comes to rest. Larger: shorter steps. Smaller: forces swing.
inline constexpr double kStiffensAfter = 30;
inline constexpr double kStiffer = 1.5;
inline constexpr double kStiffest = 50;
/// Gap that contacts harden to, at most [r]. Larger: spheres hang in the air. Smaller: the tenth of
/// it by which they differ in the end is an overlap for longer.
inline constexpr double kGapAtRest = 2e-5;
/// Overlap that is left [r].
inline constexpr double kOverlapAtRest = SettlingReport::kOverlap;
/// Share of the spheres that may still move in the end, or kFewMove of them but no more than this
/// many; and what may be missing on those [own weight]: what rolls down a gentle slope would for
/// long. The judge has a
/// tenth of his own. Larger: what creeps is taken to rest.
inline constexpr double kMovingAtRest = 5e-3;
inline constexpr double kFewMoveAtRest = 5;
inline constexpr double kMissingAtRest = SettlingReport::kMissing;
/// With rolling friction, or several sizes, a pile stands anew from where it lies, without the
/// forces that contacts have kept, before it is at rest: no more than kMovingAtRest may go farther
/// meanwhile [own radius], or that is repeated, at most so many times. Larger, and fewer: more
/// moves in another program. Otherwise: time.
inline constexpr double kStays = 0.02;
inline constexpr int kMostReloads = 6;
/// What is still in a wall by more than kOverlapRelieved after that time is lifted to a place
/// without one, by steps of this [own radius], so many at most. Larger: it may come out elsewhere.
/// Smaller: it stays wedged.
inline constexpr double kStepOfLift = 0.1;
inline constexpr int kStepsOfLift = 10;
/// After this time all is frozen as it is [sqrt(r/g)], and the report says so.
inline constexpr double kLongestHardening = 150;

// Impulses in place of springs.

/// Friction from which a pile of one size settles so: of several sizes, 98.6 % stay within 0.02 r
/// in another program, and 100 % after springs. With less, it flows for long, and forces change
/// with each step: impulses do not find their balance.
inline constexpr double kLeastFrictionOfImpulses = 0.2;
/// Time step [sqrt(r/g)], and where no more than kFewMove move. Larger: impulses are farther from
/// balance after it. Smaller: time.
inline constexpr double kStepOfImpulses = 0.05;
inline constexpr double kStepOfFew = 0.1;
/// Sweeps in a step. Larger: time. Smaller: high piles sink into themselves meanwhile.
inline constexpr int kSweepsOfImpulses = 6;
/// Sweeps in the first step, in which no contact knows its impulse.
inline constexpr int kSweepsAtFirst = 200;
/// Contacts are so many times as stiff as springs are in the beginning, until few move; then they
/// do not give way at all. Larger: more of what only its neighbours pinch is held, as with sizes.
/// Smaller: piles sink, and rise when overlaps are taken away.
inline constexpr double kStiffnessOfImpulses = 30;
/// Overlap from which it is not taken away [r]. Larger: normals turn by more meanwhile. Smaller:
/// what has given way is not relieved.
inline constexpr double kOverlapOfImpulses = 5e-3;
/// Share of an overlap that a step opens where contacts do not give way, and the fastest that it
/// does so [sqrt(g r)]. Larger: spheres are thrown apart. Smaller: they sink into one another.
inline constexpr double kOpens = 0.5;
inline constexpr double kFastestOpening = 0.5;
/// Share of the force along it that a contact forgets in a time [1/sqrt(r/g)], as one that creeps.
/// Larger: creeping keeps high piles from rest. Smaller: spheres hang that only kept forces pinch,
/// and move in another program.
inline constexpr double kSlideForgotten = 0.3;
/// Contacts from which a sphere is held in any direction. On fewer it is unstable,
/// unless something resists rolling.
inline constexpr int kContactsThatHold = 3;
/// Drag of those, and of what moves where few do [1/sqrt(r/g)]. Larger: single spheres roll for
/// long. Smaller: they swing for long where a wall is round.
inline constexpr double kDragOfLoose = 0.2;
/// Share of the spheres that may still move in the end. Larger: each that does may go far in
/// another program, as nothing but drag slows it.
inline constexpr double kMovingOfImpulses = 1e-3;
/// After this time contacts become springs, if the pile does not rest [sqrt(r/g)].
inline constexpr double kLongestImpulses = 200;
/// How much longer in x than in z a pile is whose slabs lie side by side in x.
inline constexpr double kLongerSide = 1.5;
/// Spheres from which slabs are swept on several threads. Fewer are not worth it.
inline constexpr std::size_t kSpheresWorthSharing = 500;

// A packing fraction that is asked for.

/// What may be missing of the fraction when all has settled. Larger: less accurate. Smaller: one
/// more round of settling, which adds as much at least.
inline constexpr double kFractionMissing = 0.002;
/// Drag while a pile grows denser without friction [1/sqrt(r/g)], and when little is missing of the
/// fraction: this much. Larger, and earlier: time. Smaller, and later: the pile goes on growing
/// denser while friction stops it, such as by 0.007 with the first drag, which nothing loosens.
inline constexpr double kDragOfCompaction = 1;
inline constexpr double kDragOfStop = 10;
inline constexpr double kSlowlyFrom = 0.01;
/// The fraction is measured after this time meanwhile [sqrt(r/g)]: it grows by some 0.002 with the
/// first drag. Larger: too dense a pile. Smaller: time.
inline constexpr double kTimeOfCompaction = 0.1;
/// Rounds of compaction at most. What is lost when contacts harden is added after the first.
inline constexpr int kMostCompactions = 5;

// What one thread does in one go.
inline constexpr std::size_t kPairsTogether = 512;
inline constexpr std::size_t kSpheresTogether = 256;
inline constexpr std::size_t kWallsTogether = 32;

} // namespace frostfill
