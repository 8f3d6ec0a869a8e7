// SPDX-License-Identifier: MIT
// Room: where the centre of a sphere can still get to. From this follow exact discards, leaks
// and parts that are too narrow.
#pragma once

#include "base/threads.hpp"
#include "mesh/interior/inside_test.hpp"
#include "mesh/interior/near_surface.hpp"
#include "simulation/reach/ball_slabs.hpp"
#include "simulation/reach/sparse_voxel_bits.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/reach/voxel_flood.hpp"
#include "simulation/reach/voxel_rows.hpp"
#include "simulation/world/tolerances.hpp"

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
/// sphere at rest with the sum of the radii, or every point of a triangle with the radius. Overlaps
/// of up to tau are allowed for.
///  1. The centre of a running sphere is always at least R - tau from every p: it moves along paths
///     that are swept against the obstacles kept, and appears only where it is clear of all, the
///     dropped ones included. A simulation in jumps, with both ends of each that far away and no
///     more than D apart, does so with R' for R - tau: the point of a chord nearest to p halves it,
///     so it is at least R' = sqrt((R - tau)^2 - (D/2)^2) away.
///  2. A cube is blocked only when no point of it is R' away from all p: when all of it lies in the
///     ball of one obstacle, or, by ClearSearch, in the balls of several. So a centre is always in
///     an open cube. A path leaves a cube through a face, an edge or a corner; the point where it
///     does is free, so all cubes that touch there are open, and the path can be followed from face
///     to face: six neighbours suffice.
///  3. A surface of triangles does not leak: two neighbouring open cubes on both sides of it would
///     have their middles, h apart, at least R' - h sqrt(3)/2 from the point in between, which is
///     more than h/2 for h < 0.7 R'. A larger h makes the map inactive: it then drops nothing.
///  4. Contact queries look no farther than R + Q from where a centre is. An obstacle that is
///     farther than R + Q from every reached cube that leaves anything free is in none of them.
///  5. A dropped obstacle stops no path, and need not: whatever blocks a cube beside a reached one
///     is within R' of that and so is kept, and the sweep ends there.
///  6. A large box is kept in bricks that hold all that is inside. What is in no brick is outside
///     and beyond reach of the surface: it counts as blocked, and the outside is flooded from
///     beside it.
///  7. Freezing adds obstacles, so the set only shrinks, and what was dropped stays dropped.
///
/// What the engine checks, always: contains() for the centre of every running sphere at the end of
/// each step, and what flood() and update() return. When one fails, it takes back all that it
/// dropped before it goes on, builds a new map with wider margins, adds the spheres at rest and
/// floods.
///
/// Seeds are where a sphere may yet appear: everywhere until they are withdrawn, for a place is
/// searched for everywhere before the object counts as full.
///
/// One thread at a time may change a map.
class ReachMap
{
public:
    struct Margins
    {
        double overlap = 0.05; ///< tau, by which a running sphere may overlap what is at rest [r]
        double step = 0.5;     ///< D, the longest move of a centre that is not swept [r]
        double query = 0.3;    ///< Q, from a contact within which obstacles are looked for [r]
    };
    /// Of the spheres that run or will run [r].
    struct Radii
    {
        double smallest = 1;
        double largest = 1;
    };
    struct Resolution
    {
        double voxel = 0.5;                 ///< edge of a cube, in smallest radii
        std::size_t bytes = kMostMapBytes;  ///< above which cubes are made larger
        std::size_t wholeGrid = kWholeGrid; ///< see there
    };
    /// Cubes.
    struct Unblocked
    {
        VoxelBits all; ///< of both sides
        VoxelBits inside;
    };

    /// Rasterises the surface, which lives as long as this, and keeps the open cubes inside. Of an
    /// active map `unblocked`, if given, gets what the surface alone does not block.
    ReachMap(const Surface& surface, const InsideTest& inside, const Radii& radii,
             const Margins& margins, const Resolution& resolution, Unblocked* unblocked = nullptr);
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

    /// No sphere will be released anywhere any more: only what a running one reaches stays.
    void withdrawSeeds();

    /// A sphere has come to rest; takes effect with the next flood or update. It may be added
    /// before the first flood.
    void addResting(const Eigen::Vector3d& centre, double radius)
    {
        closeBall(centre, radius, markedWords_);
    }
    /// The same for many, sorted by slabs as thick as reachOf() of the largest asks for.
    void addResting(const BallSlabs& balls, Threads& threads);
    /// How far from its centre a sphere at rest may close cubes.
    [[nodiscard]] double reachOf(double radius) const { return radius + radii_.smallest; }

    /// Reaches what is connected with a seed or the centre of a running sphere. To be called once.
    /// Like update, returns false when a running centre is out of reach: a guard has failed.
    bool flood(std::span<const Eigen::Vector3d> running);
    /// The same after spheres have come to rest, seeds were withdrawn or running spheres have
    /// moved; `running` are all of them. Looks only at what may have been cut off: the time grows
    /// with the number of cubes blocked or lost, however large the rest.
    bool update(std::span<const Eigen::Vector3d> running);

    /// p is in a reached cube.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;
    /// Some reached cube comes within `distance` of p.
    [[nodiscard]] bool reaches(const Eigen::Vector3d& p, double distance) const;
    /// The cube is reached, and confirm(x, y, z) holds for it. No cube never is.
    template <class Confirm>
    [[nodiscard]] bool isReached(CubeNumber number, Confirm&& confirm) const
    {
        return isReached(number, confirm, [](CubeNumber) { return false; });
    }
    /// The same, where confirm(x, y, z) is known to hold if isConfirmed(number) does.
    template <class Confirm, class IsConfirmed>
    [[nodiscard]] bool isReached(CubeNumber number, Confirm&& confirm,
                                 IsConfirmed&& isConfirmed) const
    {
        const VoxelWord cube = cubeOf(number);
        if (number == kNoCube || (open_[cube.word] & cube.bits) == 0)
        {
            return false;
        }
        if (isConfirmed(number))
        {
            return true;
        }
        const auto c = layout_.coordinates(cube.word);
        return confirm(c[0] + std::countr_zero(cube.bits), c[1], c[2]);
    }
    [[nodiscard]] std::size_t reachedCount() const { return reachedCount_; }

    /// Where the search for a reached cube near an obstacle has got to. As the set only shrinks, a
    /// search goes on where the last one ended: all tests of an obstacle together cost one search.
    using Cursor = std::uint32_t;
    /// No reached cube for which confirm(x, y, z) holds comes within contact and Q of a sphere at
    /// rest. What is not confirmed once is not asked for again.
    template <class Confirm>
    [[nodiscard]] bool sphereDroppable(const Eigen::Vector3d& centre, double radius, Cursor& cursor,
                                       Confirm&& confirm) const
    {
        return active_ && !findNearSphere(centre, sphereReach(radius), cursor, confirm);
    }
    [[nodiscard]] bool sphereDroppable(const Eigen::Vector3d& centre, double radius) const
    {
        Cursor fromTheTop = 0;
        return sphereDroppable(centre, radius, fromTheTop, [](int, int, int) { return true; });
    }
    /// Looks for the same of each triangle of a group, up to 64 of them, among rows from `from` on:
    /// calls found(k, cube) with its number in the group and the first cube that is confirmed.
    /// Those that lie side by side ask together, and each finds what it would find by itself.
    template <class Confirm, class Found>
    void findNear(const TriangleGroup& group, CellRow from, Confirm&& confirm, Found&& found) const;
    /// Finds none for a triangle, whatever it may hold.
    [[nodiscard]] bool polygonDroppable(std::uint32_t triangle) const;
    /// R': how near a centre may come to an obstacle with a contact distance; 0 when the margins
    /// leave nothing [r].
    [[nodiscard]] double exclusion(double contact) const;

    /// Nothing in the cubes is free; takes effect like addResting.
    void closeCubes(VoxelWord cubes) { block(cubes, markedWords_); }

    /// Those of some cubes whose middle is farther than this from the surface; of an active map.
    [[nodiscard]] VoxelBits cubesFartherThan(double distance, VoxelBits among) const;

    [[nodiscard]] const VoxelLayout& layout() const { return layout_; }
    [[nodiscard]] const VoxelBits& reached() const { return open_; }
    [[nodiscard]] const Radii& radii() const { return radii_; }
    [[nodiscard]] const Margins& margins() const { return margins_; }

private:
    /// How far from an obstacle a free place counts, distances in contact included [r].
    [[nodiscard]] double sphereReach(double radius) const
    {
        return radius + radii_.largest + margins_.query + kReachRounding;
    }
    /// How far from a triangle the middle of such a cube may be.
    [[nodiscard]] double polygonDistance() const
    {
        return radii_.largest + margins_.query + kReachRounding +
               kHalfDiagonal * layout_.frame.cell;
    }
    [[nodiscard]] VoxelBits unblockedCubes() const;
    void keepInside(const InsideTest& inside);
    void closeBall(const Eigen::Vector3d& centre, double radius, std::vector<std::size_t>& marked);
    void block(VoxelWord cubes, std::vector<std::size_t>& marked);
    void takeBlocked();
    bool anchorRunning(std::span<const Eigen::Vector3d> running);
    void keepConnected();
    void settleBeside(std::span<const VoxelWord> left);
    void settle(VoxelWord suspects);
    void forgetMarks();
    void mark(VoxelWord cubes, std::vector<std::size_t>& marked);
    template <class Confirm>
    bool findInRow(int y, int z, CellRun run, Confirm&& confirm) const;
    template <class Confirm>
    bool findNearSphere(const Eigen::Vector3d& p, double distance, Cursor& cursor,
                        Confirm&& confirm) const;

    const Surface& surface_;
    Radii radii_;
    Margins margins_;
    VoxelLayout layout_;
    bool active_ = false;
    bool flooded_ = false;
    bool seeded_ = true; ///< spheres may be released in every cube
    std::optional<Eigen::Vector3d> leak_;
    std::size_t reachedCount_ = 0;
    VoxelBits open_; ///< not blocked and inside; once flooded, the reached cubes
    /// Between updates the cubes that were reached until spheres came to rest there; during an
    /// update those that are known to be connected with a running sphere.
    SparseVoxelBits marks_;
    std::vector<std::size_t> markedWords_; ///< words of marks_ that are not empty
    VoxelFlood search_;
    std::vector<VoxelWord> unseeded_;     ///< no seeds any more
    std::vector<VoxelWord> runningCubes_; ///< of the last update
    std::vector<VoxelWord> lost_;         ///< cubes that this flood or update took out of the set
};

template <class Confirm>
bool ReachMap::findInRow(int y, int z, CellRun run, Confirm&& confirm) const
{
    return layout_.findInRow(open_, y, z, run.first, run.last,
                             [&](int x, VoxelWord) { return confirm(x, y, z); });
}

// From row `cursor` on.
template <class Confirm>
bool ReachMap::findNearSphere(const Eigen::Vector3d& p, double distance, Cursor& cursor,
                              Confirm&& confirm) const
{
    const BallRows rows(layout_.frame, p, distance, kMeetsBall);
    const CellRun widest = rows.widest();
    if (widest.first > widest.last)
    {
        return false;
    }
    std::uint64_t row = cursor;
    const bool found = rows.window().find(
        row, [&](int y, int z) { return findInRow(y, z, rows.run(y, z), confirm); },
        [&](int y, int z, int last)
        { return layout_.firstRow(open_, y, z, last, widest.first, widest.last); });
    cursor = static_cast<Cursor>(row);
    return found;
}

template <class Confirm, class Found>
void ReachMap::findNear(const TriangleGroup& asked, CellRow /*from*/, Confirm&& confirm,
                        Found&& found) const
{
    TriangleGroup group{asked.triangles, {}};
    for (const std::uint32_t t : group.triangles)
    {
        const auto& [a, b, c] = surface_[t].corner;
        group.box.extend(a).extend(b).extend(c);
    }
    const NearGroup near(surface_, group, polygonDistance());
    std::vector<bool> isFound(group.triangles.size(), false);
    std::size_t left = isFound.size();
    const auto take = [&](int x, int y, int z, VoxelWord cube)
    {
        const Eigen::Vector3d middle = layout_.frame.centre(x, y, z);
        if (near.contains(middle) && confirm(x, y, z))
        {
            for (std::size_t k = 0; k < isFound.size(); ++k)
            {
                if (!isFound[k] && near.isNear(group.triangles[k], middle))
                {
                    isFound[k] = true;
                    --left;
                    found(k, cube);
                }
            }
        }
        return left == 0;
    };
    forEachRunNear(
        layout_.frame, surface_, group, polygonDistance(),
        [&](int y, int z, CellRun run, auto&&)
        {
            if (left > 0)
            {
                layout_.findInRow(open_, y, z, run.first, run.last,
                                  [&](int x, VoxelWord cube) { return take(x, y, z, cube); });
            }
        },
        [&](int y, int z, int last, CellRun most) {
            return left == 0 ? last + 1
                             : layout_.firstRow(open_, y, z, last, most.first, most.last);
        });
}

} // namespace frostfill
