// SPDX-License-Identifier: MIT
#include "page/shape_sections.hpp"

#include "render/picture/mesh_shading.hpp"
#include "run_file/bytes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace frostfill
{
namespace
{

/// A corner of some triangles, alike in all of them.
struct Point
{
    glm::vec3 position;
    std::array<std::int16_t, 3> normal; ///< 32767 for 1
    std::uint8_t crease;                ///< distance from the nearest, 255 for kCreaseReach
};

Point pointOf(const ShadedMesh& mesh, std::size_t triangle, std::size_t corner)
{
    const glm::vec3& normal = mesh.normals[triangle][corner];
    Point point{mesh.corners(triangle)[corner], {}, 255};
    for (int axis = 0; axis < 3; ++axis)
    {
        point.normal[static_cast<std::size_t>(axis)] =
            static_cast<std::int16_t>(std::lround(32767 * normal[axis]));
    }
    if (!mesh.creaseDistances.empty())
    {
        point.crease =
            static_cast<std::uint8_t>(std::lround(255 * mesh.creaseDistances[triangle][corner]));
    }
    return point;
}

Sections pointSections(const std::vector<Point>& points)
{
    ByteWriter positions, normals, creases;
    for (const Point& point : points)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            positions.raw(point.position[axis]);
        }
        normals.raw(point.normal);
        creases.raw(point.crease);
    }
    return {{"points", std::move(positions.bytes())},
            {"normals", std::move(normals.bytes())},
            {"creases", std::move(creases.bytes())}};
}

/// For each edge the triangles beside it, in which corners it is not, and how strongly it is drawn
/// where it is no outline.
void addEdges(const ShadedMesh& mesh, Sections& sections)
{
    ByteWriter sides, kinds;
    std::int64_t before = 0;
    for (const ShadedMesh::Edge& edge : mesh.edges)
    {
        const bool paired = edge.triangles[1] != ShadedMesh::Edge::kNone;
        const std::int64_t first = edge.triangles[0];
        const std::int64_t second = paired ? edge.triangles[1] : first; // itself: there is none
        sides.difference(first - before);
        sides.difference(second - first);
        before = first;
        kinds.raw(static_cast<std::uint8_t>(edge.corners[0] + 4 * edge.corners[1]));
        kinds.raw(std::max(edge.stray ? std::uint8_t{0} : edge.crease, line_strength::kPlain));
    }
    sections.emplace_back("edges", std::move(sides.bytes()));
    sections.emplace_back("edgeKinds", std::move(kinds.bytes()));
}

} // namespace

Sections shapeSections(const TriangleMesh& mesh, const Framing& framing)
{
    const ShadedMesh shaded = shadeMesh(mesh, inUnitSpace(mesh, framing));

    // Where a vertex lies on a crease, its triangles see different normals.
    using Key = std::pair<std::uint32_t, std::array<std::int16_t, 3>>;
    std::map<Key, std::uint32_t> known;
    std::vector<Point> points;
    ByteWriter triangles;
    std::int64_t before = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const Point point = pointOf(shaded, t, corner);
            const auto [entry, isNew] = known.try_emplace(
                {static_cast<std::uint32_t>(mesh.triangles[t][corner]), point.normal},
                static_cast<std::uint32_t>(points.size()));
            if (isNew)
            {
                points.push_back(point);
            }
            triangles.difference(entry->second - before);
            before = entry->second;
        }
    }
    Sections sections = pointSections(points);
    sections.emplace_back("triangles", std::move(triangles.bytes()));
    addEdges(shaded, sections);
    return sections;
}

} // namespace frostfill
