// SPDX-License-Identifier: MIT
// Room: where the centre of a sphere can be. From this follow discards and parts that are too
// narrow.
#pragma once

#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/world/cubes.hpp"

#include <frostfill/simulation.hpp>

#include <optional>

namespace frostfill
{

struct World;

/// Where the centre of a sphere may be, as a set of cubes. The set is never too small.
///
/// Why it is right. An obstacle is a set of points p with a contact distance R: the centre of a
/// sphere at rest with the sum of the radii, or every point of a triangle with the radius. Spheres
/// may overlap what is at rest by a tau that is far above all that the engine leaves.
///  1. The centre of a running sphere is always at least R' = R - tau from every p: it moves along
///     paths that are swept against all obstacles, and appears only where it is clear of all.
///  2. A cube is closed only when no point of it is R' away from all p: when all of it lies in the
///     ball of one obstacle, or, by ClearSearch, each of its parts does. So a centre is always in
///     an open cube. A path leaves a cube through a face, an edge or a corner; the point where it
///     does is free, so all cubes that touch there are open, and six neighbours suffice to follow
///     the path.
///  3. A surface of triangles does not leak: two neighbouring open cubes on both sides of it would
///     have their middles, h apart, at least R' - h sqrt(3)/2 from the point in between, which is
///     more than h/2 for h < 0.7 R'. So cubes that are connected lie on one side, and one test of a
///     connected set tells which. With a larger h there is no set at all.
///  4. A large box is kept in bricks that hold all that is inside. What is in no brick is outside
///     and beyond reach of the surface: it counts as closed.
///  5. An obstacle farther than R from every open cube inside is touched by no sphere that runs,
///     and by none that appears, wherever it does.
///  6. Coming to rest adds obstacles, so the set only shrinks, and what is out of its reach stays
///     so. Nothing that rests may run again, though: see Discards.
struct OpenCubes
{
    Cubes cubes;
    CubeSet inside;   ///< open, and inside of the surface
    double probe = 1; ///< radius of the smallest sphere [r]

    /// R' of obstacles with contact distance R.
    [[nodiscard]] double exclusion(double contact) const { return contact - overlapOf(probe); }
    /// tau
    [[nodiscard]] static double overlapOf(double probe) { return kOverlap * probe; }
};

/// Returns the open cubes of an empty object, or none if memory is short. `probe`: the smallest
/// sphere [r]. Cubes have an edge of kReachVoxel probes, or a larger one so that a set of them
/// takes no more than `bytes`. `unblocked`, if given, gets those of both sides that the surface
/// does not close.
[[nodiscard]] std::optional<OpenCubes> openCubesOf(const Surface& surface, const InsideTest& inside,
                                                   double probe, std::size_t bytes,
                                                   Threads& threads, CubeSet* unblocked = nullptr);

/// See frostfill::inspectReach: of a run's object and its smallest radius, with the searches that
/// it has anyway. `open` gets the open cubes of the object, if they are known.
[[nodiscard]] ReachInspection inspectReach(const World& world, std::size_t bytes,
                                           std::optional<OpenCubes>& open);

} // namespace frostfill
