// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/pair_table.hpp"
#include "study/figures/panels.hpp"
#include "study/figures/section.hpp"

#include <fmt/format.h>

#include <optional>

namespace frostfill
{
namespace
{

/// The discarded polygon that lies lowest.
std::optional<std::uint32_t> lowestCovered(const Surface& surface,
                                           const std::vector<PolygonState>& states)
{
    std::optional<std::uint32_t> lowest;
    const auto height = [&](std::uint32_t t)
    {
        const auto& corner = surface[t].corner;
        return corner[0].y() + corner[1].y() + corner[2].y();
    };
    for (std::uint32_t t = 0; t < states.size(); ++t)
    {
        if (states[t] == PolygonState::discarded && (!lowest || height(t) < height(*lowest)))
        {
            lowest = t;
        }
    }
    return lowest;
}

/// Through the polygon's longest edge and into the object, seen along the surface.
SectionPlane planeThrough(const Surface& surface, std::uint32_t polygon, std::size_t& edge)
{
    const SurfaceTriangle& triangle = surface[polygon];
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const double length = (triangle.corner[(k + 1) % 3] - triangle.corner[k]).norm();
        if (length > longest)
        {
            longest = length;
            edge = k;
        }
    }
    const Eigen::Vector3d& a = triangle.corner[edge];
    const Eigen::Vector3d& b = triangle.corner[(edge + 1) % 3];
    return {(a + b) / 2, (b - a).normalized(), surface.bound(polygon).normal};
}

/// The polygon's vertices and the rays from them: `x,y,dx,dy`, the third beside the plane.
Table raysOf(const Surface& surface, std::uint32_t polygon, std::size_t edge,
             const SectionPlane& plane, double unit)
{
    Table table;
    table.headings = {"where", "x", "y", "dx", "dy"};
    for (std::size_t k = 0; k < 3; ++k)
    {
        const std::size_t corner = (edge + k) % 3;
        const std::uint32_t vertex = surface.mesh().triangles[polygon][corner];
        const Eigen::Vector2d from = plane.project(surface[polygon].corner[corner]) / unit;
        const Eigen::Vector3d ray = surface.vertexNormal(vertex);
        table.rows.push_back({k < 2 ? "edge" : "beside", fmt::format("{:.5f}", from.x()),
                              fmt::format("{:.5f}", from.y()),
                              fmt::format("{:.5f}", plane.across.dot(ray)),
                              fmt::format("{:.5f}", plane.upward.dot(ray))});
    }
    return table;
}

void writeSections(const FigureFolder& folder, const Scene& scene, const TriangleMesh& mesh)
{
    const std::size_t spheres[] = {*scene.spheres.count * 3 / 5};
    const FigureState moment = statesOf(scene, mesh, spheres).front();
    const double unit = moment.snapshot.radii.front();
    // The torus stands upright: its middle plane is that of x and y.
    const SectionPlane middle = {boundingBox(mesh).center(), {1, 0, 0}, {0, 1, 0}};
    folder.write("interaction-spheres.csv", circlesOf(moment.snapshot, middle, unit));
    folder.write("interaction-polygons.csv",
                 tracesOf(mesh, moment.snapshot.polygons, middle, unit));

    const FigureState end = endOf(scene, mesh);
    const Surface surface(mesh);
    // Even where none is covered there is something to draw: the lowest polygon.
    const std::uint32_t polygon = lowestCovered(surface, end.snapshot.polygons).value_or(0);
    std::size_t edge = 0;
    const SectionPlane plane = planeThrough(surface, polygon, edge);
    folder.write("interaction-covering.csv", circlesOf(end.snapshot, plane, unit));
    folder.write("interaction-rays.csv", raysOf(surface, polygon, edge, plane, unit));
}

void makeInteractionData(const FigureFolder& folder)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.search = {SphereSearch::grid, PolygonSearch::grid};
    if (folder.quick())
    {
        scene.spheres.count = 60;
    }
    const TriangleMesh mesh = builtInMesh("torus");
    writeSections(folder, scene, mesh);

    // The paper's example: three groups a set, and the third set runs.
    Scene sets = scene;
    sets.spheres.radius = Radii(sphereRadius(scene, inspectMesh(mesh)));
    sets.spheres.groupsPerSet = 3;
    sets.freezing.everySets = 1;
    sets.discard.rule = DiscardRule::none;
    const std::size_t third[] = {std::size_t{9} * sets.spheres.groupSize};
    sets.spheres.count = third[0];
    folder.write("interaction-pairs.csv", pairTable(statesOf(sets, mesh, third).front().snapshot));
}

} // namespace

Figure interactionFigure()
{
    return {"interaction",
            "PAPER, Figure 2: spheres and polygons, a covered polygon, sets of groups",
            false,
            0.5,
            makeInteractionData,
            embedded::figure_interaction};
}

} // namespace frostfill
