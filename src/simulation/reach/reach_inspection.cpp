// SPDX-License-Identifier: MIT
#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/clear_search.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

/// What of an object spheres of a radius cannot fill.
struct UnfilledSpace
{
    double volume = 0;                    ///< that no sphere covers, crumbs included [r^3]
    std::vector<UnreachableVolume> parts; ///< connected, largest first [r]
};

// Cubes up to `reach` to the left and right of a word's, those of the words beside it included.
std::uint64_t widened(const Cubes& cubes, const CubeSet& set, const GridPlace& at, int reach)
{
    const auto [x, y, z] = at;
    const std::uint64_t here = set[cubes.wordIfAny(x, y, z)];
    const std::uint64_t left = set[cubes.wordIfAny(x - 1, y, z)];
    const std::uint64_t right = set[cubes.wordIfAny(x + 1, y, z)];
    std::uint64_t result = here;
    for (int shift = 1; shift <= reach; ++shift)
    {
        result |= here << shift | here >> shift | left >> (64 - shift) | right << (64 - shift);
    }
    return result;
}

// Of a word, the cubes whose middle comes within `radius` of a cube of the set, radius in cubes.
std::uint64_t dilated(const Cubes& cubes, const CubeSet& set, std::size_t word, double radius)
{
    const auto square = [](int steps) // of the distance from a middle to the cube so many farther
    {
        const double distance = std::max(0.0, std::abs(steps) - 0.5);
        return distance * distance;
    };
    const auto [x, y, z] = cubes.first(word);
    const int reach = static_cast<int>(std::lround(radius));
    std::uint64_t result = 0;
    for (int dy = -reach; dy <= reach; ++dy)
    {
        for (int dz = -reach; dz <= reach; ++dz)
        {
            const double rest = radius * radius - square(dy) - square(dz);
            if (rest >= 0)
            {
                result |= widened(cubes, set, {x / 64, y + dy, z + dz},
                                  std::min(63, static_cast<int>(std::lround(std::sqrt(rest)))));
            }
        }
    }
    return result;
}

std::vector<UnreachableVolume> findParts(const Cubes& cubes, CubeSet left, double smallestPart)
{
    std::vector<UnreachableVolume> parts;
    const double edge = cubes.frame().cell;
    for (std::size_t word = 0; word < left.size(); ++word)
    {
        while (left[word] != 0)
        {
            std::size_t count = 0;
            UnreachableVolume part;
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            const auto take = [&](const GridPlace& cube)
            {
                const Eigen::Vector3d p = cubes.middle(cube);
                ++count;
                sum += p;
                part.box.extend(Eigen::Vector3d(p.array() - edge / 2));
                part.box.extend(Eigen::Vector3d(p.array() + edge / 2));
            };
            cubes.takeConnected(left, {word, left[word] & -left[word]},
                                [&](CubeWord found) { cubes.forEachCube(found, take); });
            part.volume = static_cast<double>(count) * edge * edge * edge;
            part.centre = sum / static_cast<double>(count);
            if (part.volume >= smallestPart)
            {
                parts.push_back(part);
            }
        }
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.volume > b.volume; });
    return parts;
}

/// Cubes inside the object whose middle is farther from every open cube than the probe.
/// `unblocked`: see openCubesOf; `inside`: of them those inside of the surface. Parts smaller than
/// `smallestPart` [r^3] are left out. Only of the few cubes that are blocked and that no sphere
/// covers, wherever they are, each is asked for its side.
UnfilledSpace unfilledSpace(const OpenCubes& open, const CubeSet& unblocked,
                            const CubeSet& unblockedInside, const InsideTest& inside,
                            double smallestPart, Threads& threads)
{
    const Cubes& cubes = open.cubes;
    const double edge = cubes.frame().cell;
    CubeSet unfilled(cubes.words(), 0);
    const auto look = [&](std::size_t word)
    {
        const std::uint64_t blocked = cubes.inGrid(word) & ~unblocked[word];
        const std::uint64_t maybe = (blocked | unblockedInside[word]) & ~open.inside[word];
        const std::uint64_t here =
            maybe == 0 ? 0 : maybe & ~dilated(cubes, open.inside, word, open.probe / edge);
        unfilled[word] = here & unblockedInside[word];
        for (std::uint64_t left = here & blocked; left != 0; left &= left - 1)
        {
            const CubeWord cube{word, left & -left};
            cubes.forEachCube(
                cube, [&](const GridPlace& place)
                { unfilled[word] |= inside.contains(cubes.middle(place)) ? cube.bits : 0; });
        }
    };
    threads.forEach(cubes.words(), look);
    std::size_t count = 0;
    for (const std::uint64_t word : unfilled)
    {
        count += static_cast<std::size_t>(std::popcount(word));
    }
    return {static_cast<double>(count) * edge * edge * edge,
            findParts(cubes, std::move(unfilled), smallestPart)};
}

constexpr double kOneSphere = 4.0 / 3.0 * std::numbers::pi; // [r^3]

/// Sets of cubes in memory at once.
constexpr std::size_t kSetsOfCubes = 4;

/// In radii, about the middle of the mesh's box.
TriangleMesh inRadii(TriangleMesh mesh, const Eigen::Vector3d& origin, double radius)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = (vertex - origin) / radius;
    }
    return mesh;
}

// A cube is closed when one triangle excludes all of it; here those go, too, that several exclude
// together. A cube whose middle is a place for a sphere is none of them.
void closeCoveredCubes(OpenCubes& open, const Surface& surface, const ClearSearch& search,
                       Threads& threads)
{
    const Cubes& cubes = open.cubes;
    const CubeSet clear = cubesFartherThan(surface, cubes, open.probe, open.inside, threads);
    const auto look = [&](std::size_t word)
    {
        std::uint64_t& its = open.inside[word];
        for (std::uint64_t left = its & ~clear[word]; left != 0; left &= left - 1)
        {
            const CubeWord cube{word, left & -left};
            cubes.forEachCube(cube,
                              [&](const GridPlace& place)
                              {
                                  const bool holds =
                                      search.mayHold(cubes.middle(place), cubes.frame().cell, 0);
                                  its &= holds ? ~std::uint64_t{0} : ~cube.bits;
                              });
        }
    };
    threads.forEach(cubes.words(), look);
}

/// The edges of an object are too narrow for a sphere all along, and make one thin part.
bool isThin(const UnreachableVolume& part)
{
    return part.volume < kShareOfBox * part.box.volume();
}

ReachInspection inspect(const Surface& surface, const TriangleGrid& triangles,
                        const InsideTest& inside, double radius, std::size_t bytes,
                        Threads& threads, std::optional<OpenCubes>& open)
{
    ReachInspection result;
    CubeSet unblocked;
    open = openCubesOf(surface, inside, radius, bytes / kSetsOfCubes, threads, &unblocked);
    result.known = open.has_value();
    if (!open)
    {
        return result;
    }
    const CubeSet unblockedInside = open->inside;
    const SphereGrid nothing(GridFrame{});
    closeCoveredCubes(*open, surface, ClearSearch(nothing, triangles, radius), threads);
    UnfilledSpace unfilled = unfilledSpace(*open, unblocked, unblockedInside, inside,
                                           kOneSphere * radius * radius * radius, threads);
    result.fits = std::any_of(open->inside.begin(), open->inside.end(),
                              [](std::uint64_t word) { return word != 0; });
    result.unreachable = unfilled.volume;
    result.resolution = open->cubes.frame().cell;
    std::erase_if(unfilled.parts, isThin);
    result.parts = std::move(unfilled.parts);
    return result;
}

/// From units of `length` about `origin`.
ReachInspection inMeshUnits(ReachInspection result, const Eigen::Vector3d& origin, double length)
{
    const double volume = length * length * length;
    result.unreachable *= volume;
    result.resolution *= length;
    for (UnreachableVolume& part : result.parts)
    {
        part.volume *= volume;
        part.centre = origin + length * part.centre;
        part.box =
            Eigen::AlignedBox3d(origin + length * part.box.min(), origin + length * part.box.max());
    }
    return result;
}

} // namespace

ReachInspection inspectReach(const TriangleMesh& mesh, double radius, std::size_t bytes)
{
    const Eigen::Vector3d origin = boundingBox(mesh).center();
    const Surface surface(inRadii(mesh, origin, radius));
    if (memoryNeed(ObjectSize(surface.mesh()), 0) > static_cast<double>(bytes) ||
        surface.box().sizes().maxCoeff() > kMaxLength)
    {
        return {};
    }
    const TriangleGrid triangles(
        surface, GridFrame::cover(surface.box(), kTriangleCell, kGridMargin), kTriangleReach);
    const InsideTest inside(surface, triangles);
    Threads threads(0);
    std::optional<OpenCubes> open;
    return inMeshUnits(inspect(surface, triangles, inside, 1, bytes, threads, open), origin,
                       radius);
}

ReachInspection inspectReach(const World& world, std::size_t bytes, std::optional<OpenCubes>& open)
{
    Threads threads(world.scene.threads);
    return inMeshUnits(inspect(world.surface, world.triangles, world.inside, world.radii.smallest(),
                               bytes, threads, open),
                       world.frame.toMesh(Eigen::Vector3d::Zero()), world.frame.length);
}

} // namespace frostfill
