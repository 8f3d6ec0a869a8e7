// SPDX-License-Identifier: MIT
#include "study/figures/section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

const char* nameOf(SphereState state)
{
    constexpr const char* kNames[] = {"running", "frozen", "discarded"};
    return kNames[static_cast<std::size_t>(state)];
}

/// Where the plane cuts the triangle's edges: none or two points, but for touching corners.
std::vector<Eigen::Vector2d> cutsOf(const std::array<Eigen::Vector3d, 3>& corners,
                                    const SectionPlane& plane)
{
    std::vector<Eigen::Vector2d> cuts;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Eigen::Vector3d& a = corners[k];
        const Eigen::Vector3d& b = corners[(k + 1) % 3];
        const double da = plane.distance(a);
        const double db = plane.distance(b);
        if ((da < 0) != (db < 0))
        {
            cuts.push_back(plane.project(a + (b - a) * (da / (da - db))));
        }
    }
    return cuts;
}

} // namespace

Table circlesOf(const Snapshot& snapshot, const SectionPlane& plane, double unit)
{
    Table table;
    table.headings = {"state", "x", "y", "radius"};
    for (std::size_t id = 0; id < snapshot.centres.size(); ++id)
    {
        const Eigen::Vector3d centre = snapshot.centres[id].cast<double>() + snapshot.origin;
        const double radius = snapshot.radii[id];
        const double away = plane.distance(centre);
        if (std::abs(away) >= radius)
        {
            continue;
        }
        const Eigen::Vector2d p = plane.project(centre) / unit;
        table.rows.push_back(
            {nameOf(snapshot.states[id]), fmt::format("{:.5f}", p.x()),
             fmt::format("{:.5f}", p.y()),
             fmt::format("{:.5f}", std::sqrt(radius * radius - away * away) / unit)});
    }
    return table;
}

Table tracesOf(const TriangleMesh& mesh, const std::vector<PolygonState>& states,
               const SectionPlane& plane, double unit)
{
    Table table;
    table.headings = {"state", "polygon", "x", "y", "dx", "dy"};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
        {
            corners[k] = mesh.vertices[mesh.triangles[t][k]];
        }
        const auto cuts = cutsOf(corners, plane);
        if (cuts.size() != 2)
        {
            continue;
        }
        const Eigen::Vector2d from = cuts[0] / unit;
        const Eigen::Vector2d way = cuts[1] / unit - from;
        table.rows.push_back({states[t] == PolygonState::discarded ? "discarded" : "active",
                              fmt::format("{}", t), fmt::format("{:.5f}", from.x()),
                              fmt::format("{:.5f}", from.y()), fmt::format("{:.5f}", way.x()),
                              fmt::format("{:.5f}", way.y())});
    }
    return table;
}

} // namespace frostfill
