// SPDX-License-Identifier: MIT
#pragma once

#include <mesh/inside_test.hpp>
#include <simulation/voxel_flood.hpp>

#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Where the centre of a running sphere can still get to, as a set of cubes. The set is never too
/// small, so an obstacle (a sphere at rest, a triangle) that is out of its reach can be dropped for
/// good without changing one bit of the arithmetic.
///
/// Why it is right. An obstacle is a set of points p with a contact distance R: the centre of a
/// sphere at rest with the sum of the radii, or every point of a triangle with the radius.
///  1. Jump lemma. Both ends of a step are at least R - tau from p, and the step is no longer than
///     D. The point of the chord nearest to p is at least sqrt((R - tau)^2 - (D/2)^2) = R' away,
///     for it is nearest when it halves the chord. So the jumps of a simulation are continuous
///     paths in what the balls of radius R' leave free.
///  2. A cube is blocked only when all of it lies in one such ball. A path leaves a cube through
///     a face, an edge or a corner; the point where it does is free, so all cubes that touch there
///     are open, and the path can be followed from face to face: six neighbours suffice.
///  3. A surface of triangles does not leak: two neighbouring open cubes on both sides of it would
///     have their middles, h apart, at least R' - h sqrt(3)/2 from the point in between, which is
///     more than h/2 for h < 0.7 R'. A larger h makes the map inactive: it then drops nothing.
///  4. Contact queries use positions at most Q from an end of a step, which lies in a reached cube.
///     An obstacle whose distance from every reached cube exceeds R + Q is in none of them.
///  5. Freezing adds obstacles, so the set only shrinks, and what was dropped stays dropped.
///
/// What the engine checks, always:
///  - contains() for the centre of every running sphere at the end of each step, and where a sphere
///    is released; and what flood() and update() return;
///  - no position used in a contact query is farther than Q from the last end of a step. Q also
///    covers skins of neighbour lists, polish at freezing and gaps of support tests.
/// These alone make dropping exact, by 4 and 5. When one fails, the engine takes back all that it
/// dropped before it goes on, builds a new map with wider margins, adds the spheres at rest and
/// floods. What it keeps so that none ever fails, by 1 to 3:
///  - at the end of each step, where a sphere is released and where it is frozen, its centre is
///    inside and no nearer than R - tau to an obstacle or to another running sphere (which will be
///    one);
///  - no centre moves farther than D in a step. A jump over free flight may be longer when the
///    whole of its way is swept against the obstacles that are kept: to leave the reached cubes it
///    would have to cross a blocked one beside them, which no kept obstacle lets it, and no dropped
///    one is that near.
///
/// Seeds decide what counts as free to be released in, not whether the map is right: a place
/// without a seed is merely lost to releases once it is cut off. For results that are equal
/// with and without dropping, the engine keeps to contains() in both.
///
/// One thread at a time may change a map.
class ReachMap
{
public:
    struct Margins
    {
        double overlap = 0.05; ///< tau, by which spheres may overlap at the end of a step [r]
        double step = 0.5;     ///< D, the longest move of a centre between two checks [r]
        double query = 0.3;    ///< Q, between an end of a step and a position queried [r]
    };
    /// Of the spheres that run or will run [r].
    struct Radii
    {
        double smallest = 1;
        double largest = 1;
    };
    struct Resolution
    {
        double voxel = 0.5;                         ///< edge of a cube, in smallest radii
        std::size_t bytes = std::size_t{512} << 20; ///< above which cubes are made larger
    };

    /// Rasterises the surface, which lives as long as this, and keeps the open cubes inside.
    ReachMap(const Surface& surface, const InsideTest& inside, const Radii& radii,
             const Margins& margins, const Resolution& resolution);
    ReachMap(const Surface& surface, const InsideTest& inside, const Radii& radii,
             const Margins& margins)
        : ReachMap(surface, inside, radii, margins, Resolution{})
    {
    }

    /// Without a leak, and with cubes that are small enough. Otherwise everything counts as within
    /// reach and nothing can be dropped.
    [[nodiscard]] bool active() const { return active_; }
    /// A point in a hole that is wider than the smallest sphere.
    [[nodiscard]] const std::optional<Eigen::Vector3d>& leak() const { return leak_; }

    // Seeds: the cubes where a sphere may yet be released, everywhere at first. Each call replaces
    // those set before. Once flooded, seeds out of reach count for nothing. A cube that is blocked
    // stops being a seed by itself.
    void seedEverywhere();
    void seedAbove(double height); ///< cubes that reach above y = height
    /// Cubes that come within `distance` of one of the points.
    void setSeeds(std::span<const Eigen::Vector3d> points, double distance);
    /// No sphere will be released in the cube of p any more.
    void withdrawSeed(const Eigen::Vector3d& p);

    /// A sphere has come to rest; takes effect with the next flood or update. It may be added
    /// before the first flood.
    void addResting(const Eigen::Vector3d& centre, double radius);

    /// Reaches what is connected with a seed or the centre of a running sphere. To be called once.
    /// Like update, returns false when a running centre is out of reach: a guard has failed.
    bool flood(std::span<const Eigen::Vector3d> running);
    /// The same after spheres have come to rest, seeds were changed or running spheres have moved;
    /// `running` are all of them. Looks only at what may have been cut off: the time grows with the
    /// number of cubes blocked or lost, however large the rest.
    bool update(std::span<const Eigen::Vector3d> running);

    /// p is in a reached cube.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;
    /// Some reached cube comes within `distance` of p.
    [[nodiscard]] bool reaches(const Eigen::Vector3d& p, double distance) const;
    [[nodiscard]] std::size_t reachedCount() const { return reachedCount_; }

    /// Where the search for a reached cube near an obstacle has got to. As the set only shrinks, a
    /// search goes on where the last one ended: all tests of an obstacle together cost one search.
    using Cursor = std::uint32_t;
    [[nodiscard]] bool sphereDroppable(const Eigen::Vector3d& centre, double radius,
                                       Cursor& cursor) const;
    [[nodiscard]] bool sphereDroppable(const Eigen::Vector3d& centre, double radius) const
    {
        return active_ && !reaches(centre, radius + radii_.largest + margins_.query);
    }
    /// The map keeps the cursors of triangles.
    [[nodiscard]] bool polygonDroppable(std::uint32_t triangle);

    /// Cubes that the last flood or update took out of the set, blocked or cut off: visit(middle).
    /// Only obstacles near one of them can have become droppable.
    template <class Visit>
    void forEachLost(Visit&& visit) const
    {
        for (const VoxelWord lost : lost_)
        {
            layout_.forEachCube(lost,
                                [&](int x, int y, int z) { visit(layout_.frame.centre(x, y, z)); });
        }
    }
    /// Boxes of four cubes a side that hold the lost cubes, each box once.
    [[nodiscard]] std::vector<Eigen::AlignedBox3d> lostBlocks() const;

    /// Cubes, inside or outside, that the surface alone does not block; of an active map.
    [[nodiscard]] VoxelBits unblockedCubes() const;

    [[nodiscard]] const VoxelLayout& layout() const { return layout_; }
    [[nodiscard]] const VoxelBits& reached() const { return open_; }
    [[nodiscard]] const Radii& radii() const { return radii_; }
    [[nodiscard]] const Margins& margins() const { return margins_; }

private:
    void keepInside(const InsideTest& inside);
    void replaceSeeds(VoxelBits seeds);
    void block(VoxelWord cubes);
    void takeBlocked();
    bool anchorRunning(std::span<const Eigen::Vector3d> running);
    void settle(VoxelWord suspects);
    void mark(VoxelWord cubes);
    [[nodiscard]] bool findReached(const Eigen::Vector3d& p, double distance, Cursor& cursor) const;
    [[nodiscard]] double exclusion(double contact) const;

    const Surface& surface_;
    Radii radii_;
    Margins margins_;
    VoxelLayout layout_;
    bool active_ = false;
    bool flooded_ = false;
    std::optional<Eigen::Vector3d> leak_;
    std::size_t reachedCount_ = 0;
    VoxelBits open_;  ///< not blocked and inside; once flooded, the reached cubes
    VoxelBits seeds_; ///< where spheres may be released; some may be blocked by now
    /// Between updates the cubes that were reached until spheres came to rest there; during an
    /// update those that are known to be connected with a seed.
    VoxelBits marks_;
    std::vector<std::size_t> markedWords_; ///< words of marks_ that are not empty
    VoxelFlood search_;
    std::vector<VoxelWord> unseeded_;     ///< no seeds any more
    std::vector<VoxelWord> runningCubes_; ///< seeds of the last update
    std::vector<VoxelWord> lost_;
    std::vector<Cursor> triangleCursor_; ///< [#T]
};

} // namespace frostfill
