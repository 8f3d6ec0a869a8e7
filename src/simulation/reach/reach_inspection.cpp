// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_inspection.hpp"

#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/clear_search.hpp"
#include "simulation/world/memory_need.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr double kOneSphere = 4.0 / 3.0 * std::numbers::pi; // [r^3]

/// For each cell of a radius of a mesh of its own, and for each near walls: the map, of which no
/// cube is made larger, and the lists of triangles. [bytes]
constexpr double kBytesPerCell = 5;
constexpr double kBytesPerWallCell = 20;
/// Sets of cubes in memory at once.
constexpr std::size_t kSetsOfCubes = 4;

double memoryOf(const ObjectSize& object)
{
    const double cells = object.cells();
    return kBytesPerCell * cells + kBytesPerWallCell * std::min(cells, object.wallCells());
}

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
    const CubeSet clear = cubesFartherThan(surface, cubes, open.probe, open.inside);
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
    EmptyObject empty = openCubesOf(surface, inside, radius, bytes / kSetsOfCubes, &unblocked);
    open = std::move(empty.open);
    result.leak = empty.leak;
    result.known = open || result.leak;
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
    if (result.leak)
    {
        result.leak = origin + length * *result.leak;
    }
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
    if (memoryOf(ObjectSize(surface.mesh())) > static_cast<double>(bytes) ||
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
