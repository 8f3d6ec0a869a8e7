// SPDX-License-Identifier: MIT
#include "mesh/interior/interior_volume.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/repair/inspect_interior.hpp"
#include "mesh/triangle_shape.hpp"

#include <optional>

namespace frostfill
{
namespace
{

std::size_t countDuplicates(const TriangleMesh& mesh)
{
    std::vector<Triangle> sorted;
    sorted.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
    {
        if (!repeatsCorner(t))
        {
            sorted.push_back(sortedCorners(t));
        }
    }
    std::sort(sorted.begin(), sorted.end());
    const auto end = std::unique(sorted.begin(), sorted.end());
    return static_cast<std::size_t>(sorted.end() - end);
}

std::size_t countUnused(const TriangleMesh& mesh)
{
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Triangle& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            used[corner] = true;
        }
    }
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

void inspectEdges(MeshReport& report, const TriangleMesh& mesh, const EdgeTable& edges)
{
    std::optional<Eigen::Vector3d> firstDefect;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const bool boundary = uses.size() == 1;
            const bool nonManifold = uses.size() > 2;
            const bool inconsistent = uses.size() == 2 && uses[0].forward == uses[1].forward;
            report.boundaryEdges += boundary ? 1U : 0U;
            report.nonManifoldEdges += nonManifold ? 1U : 0U;
            const bool unbalanced = nonManifold && !cancels(uses);
            report.unbalancedEdges += unbalanced ? 1U : 0U;
            report.inconsistentEdges += inconsistent ? 1U : 0U;
            if ((boundary || unbalanced || inconsistent) && !firstDefect)
            {
                firstDefect = 0.5 * (mesh.vertices[uses[0].low] + mesh.vertices[uses[0].high]);
            }
        });
    report.firstDefect = firstDefect.value_or(Eigen::Vector3d::Zero());
}

/// The genus by Euler's formula over all pieces. A vertex where several fans of triangles meet
/// counts once for each fan, as if the surface were cut there.
int countHandles(const TriangleMesh& mesh, const EdgeTable& edges, std::size_t pieces)
{
    DisjointSets corners(3 * mesh.triangles.size());
    long edgeCount = 0;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            ++edgeCount;
            for (const EdgeUse& use : uses.subspan(1))
            {
                joinCorners(corners, mesh, uses[0], use);
            }
        });
    long vertexCount = 0;
    long faceCount = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        if (repeatsCorner(mesh.triangles[triangle]))
        {
            continue;
        }
        ++faceCount;
        for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
        {
            vertexCount += corners.find(corner) == corner ? 1 : 0;
        }
    }
    return static_cast<int>(static_cast<long>(pieces) - (vertexCount - edgeCount + faceCount) / 2);
}

} // namespace

MeshReport inspectMesh(const TriangleMesh& mesh)
{
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.triangles = mesh.triangles.size();
    report.degenerateTriangles =
        static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                               [&](const Triangle& t) { return isFlat(mesh, t); }));
    report.duplicateTriangles = countDuplicates(mesh);
    report.unusedVertices = countUnused(mesh);

    const EdgeTable edges(mesh);
    inspectEdges(report, mesh, edges);
    report.components = connectedPieces(mesh, edges).size();
    report.genus = countHandles(mesh, edges, report.components);
    report.volume = signedVolume(mesh);
    report.area = surfaceArea(mesh);
    report.box = boundingBox(mesh);
    return report;
}

MeshReport inspectInterior(const TriangleMesh& mesh, const Walls& walls)
{
    MeshReport report = inspectMesh(mesh);
    report.crossedTriangles = walls.crossed;
    report.firstCrossing = walls.firstCrossing;
    if (!walls.none())
    {
        report.volume = interiorVolume(mesh);
    }
    return report;
}

MeshReport inspectInterior(const TriangleMesh& mesh)
{
    return inspectInterior(mesh, classifyWalls(mesh));
}

} // namespace frostfill
