// SPDX-License-Identifier: MIT
#include <frostfill/simulation.hpp>

#include <mesh/inside_test.hpp>
#include <simulation/clear_search.hpp>
#include <simulation/reach_map.hpp>
#include <simulation/reach_report.hpp>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr double kOneSphere = 4.0 / 3.0 * std::numbers::pi; // [r^3]
constexpr double kTriangleReach = 1.5;                      // [r]
constexpr double kRounding = 1e-9;                          // [r]

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
// together.
void closeCoveredCubes(ReachMap& map, ClearSearch& search)
{
    const auto everything = [](const Eigen::Vector3d&, double) { return true; };
    const VoxelLayout& layout = map.layout();
    const VoxelBits open = map.reached();
    for (std::size_t word = 0; word < open.size(); ++word)
    {
        layout.forEachCube({word, open[word]},
                           [&](int x, int y, int z)
                           {
                               const Eigen::Vector3d middle = layout.frame.centre(x, y, z);
                               if (search.look(middle, layout.frame.cell, everything) ==
                                   ClearSearch::Answer::none)
                               {
                                   map.closeCube(x, y, z);
                               }
                           });
    }
    (void)map.flood({});
}

} // namespace

ReachInspection inspectReach(const TriangleMesh& mesh, double radius, std::size_t bytes)
{
    ReachInspection result;
    const Eigen::Vector3d origin = boundingBox(mesh).center();
    const Surface surface(inRadii(mesh, origin, radius));
    // As many cells as the map may have cubes, or fewer.
    const Eigen::Vector3d box = surface.box().sizes();
    if ((box.array() + 4).prod() > static_cast<double>(bytes) / 4)
    {
        return result;
    }
    const GridFrame cells = GridFrame::cover(surface.box(), 1, 2);
    const TriangleGrid triangles(surface, cells, kTriangleReach);
    const InsideTest inside(surface, triangles);
    ReachMap map(surface, inside, ReachMap::Radii{}, {kRounding, 0, 0}, {0.5, bytes});
    result.known = map.active() || map.leak();
    if (map.leak())
    {
        result.leak = origin + radius * *map.leak();
    }
    if (!map.active())
    {
        return result;
    }
    const SphereGrid nothing(cells);
    ClearSearch search(nothing, surface, triangles, 1, kRounding);
    closeCoveredCubes(map, search);
    const ReachReport report = reportReach(map, inside, kOneSphere);
    const double unit = radius * radius * radius;
    result.fits = map.reachedCount() > 0;
    result.unreachable = report.unreachedVolume * unit;
    result.resolution = report.resolution * radius;
    for (const UnreachablePart& part : report.parts)
    {
        result.parts.push_back({part.volume * unit, origin + radius * part.centre,
                                Eigen::AlignedBox3d(origin + radius * part.box.min(),
                                                    origin + radius * part.box.max())});
    }
    return result;
}

} // namespace frostfill
