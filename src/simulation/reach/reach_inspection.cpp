// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_inspection.hpp"

#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/clear_search.hpp"
#include "simulation/reach/reach_map.hpp"
#include "simulation/reach/reach_report.hpp"
#include "simulation/reach/tolerances.hpp"
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

// A cube is blocked when one triangle excludes all of it; here those go, too, that several exclude
// together. A cube whose middle is a place for a sphere is none of them.
void closeCoveredCubes(ReachMap& map, const ClearSearch& search, Threads& threads)
{
    const VoxelLayout& layout = map.layout();
    const VoxelBits clear = map.cubesFartherThan(map.radii().smallest, map.reached());
    VoxelBits covered(layout.words, 0);
    threads.forEach(layout.words,
                    [&](std::size_t word)
                    {
                        const auto look = [&](int x, int y, int z)
                        {
                            if (!search.mayBeClear(layout.frame.centre(x, y, z), layout.frame.cell))
                            {
                                covered[word] |= layout.at(x, y, z).bits;
                            }
                        };
                        const std::uint64_t open = map.reached()[word];
                        if ((open & ~clear[word]) != 0)
                        {
                            layout.forEachCube({word, open & ~clear[word]}, look);
                        }
                    });
    for (std::size_t word = 0; word < covered.size(); ++word)
    {
        map.closeCubes({word, covered[word]});
    }
    (void)map.flood({});
}

/// The edges of an object are too narrow for a sphere all along, and make one thin part.
bool isThin(const UnreachablePart& part)
{
    return part.volume < kShareOfBox * part.box.volume();
}

ReachInspection inspect(const Surface& surface, const TriangleGrid& triangles,
                        const InsideTest& inside, double radius, std::size_t bytes,
                        Threads& threads)
{
    ReachInspection result;
    ReachMap::Unblocked unblocked;
    ReachMap map(surface, inside, {radius, radius}, {kReachRounding, 0, 0},
                 {kInspectionVoxel, bytes}, &unblocked);
    result.known = map.active() || map.leak();
    result.leak = map.leak();
    if (!map.active())
    {
        return result;
    }
    const SphereGrid nothing(GridFrame{});
    const ClearSearch search(nothing, surface, triangles, radius, kReachRounding);
    closeCoveredCubes(map, search, threads);
    const ReachReport report =
        reportReach(map, unblocked, inside, kOneSphere * radius * radius * radius, threads);
    result.fits = map.reachedCount() > 0;
    result.unreachable = report.unreachedVolume;
    result.resolution = report.resolution;
    for (const UnreachablePart& part : report.parts)
    {
        if (!isThin(part))
        {
            result.parts.push_back({part.volume, part.centre, part.box});
        }
    }
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
    return inMeshUnits(inspect(surface, triangles, inside, 1, bytes, threads), origin, radius);
}

ReachInspection inspectReach(const World& world, std::size_t bytes)
{
    Threads threads(world.scene.threads);
    return inMeshUnits(inspect(world.surface, world.triangles, world.inside, world.radii.smallest(),
                               bytes, threads),
                       world.frame.toMesh(Eigen::Vector3d::Zero()), world.frame.length);
}

} // namespace frostfill
