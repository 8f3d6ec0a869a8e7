// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <fmt/format.h>

#include <optional>

namespace frostfill
{
namespace
{

/// Triangles with the corners of one before them. They share all edges, so it is enough to look at
/// the edge of the two lowest corners.
std::size_t countDuplicates(const TriangleMesh& mesh, const EdgeTable& edges)
{
    std::size_t count = 0;
    std::vector<std::uint32_t> thirds;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto thirdOf = [&](const EdgeUse& use)
            { return mesh.triangles[use.triangle][(use.corner + 2U) % 3U]; };
            if (uses.size() == 2 && thirdOf(uses[0]) != thirdOf(uses[1])) // as nearly always
            {
                return;
            }
            thirds.clear();
            for (const EdgeUse& use : uses)
            {
                const std::uint32_t third = thirdOf(use);
                if (third > use.high)
                {
                    thirds.push_back(third);
                }
            }
            std::sort(thirds.begin(), thirds.end());
            count +=
                static_cast<std::size_t>(thirds.end() - std::unique(thirds.begin(), thirds.end()));
        });
    return count;
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

/// Joins the corners (3 x triangle + corner) of two triangles that meet along an edge. Returns how
/// many of the two pairs were apart.
std::size_t joinCorners(DisjointSets& corners, const TriangleMesh& mesh, const EdgeUse& a,
                        const EdgeUse& b)
{
    const auto cornerAt = [&](const EdgeUse& use, std::uint32_t vertex)
    {
        const std::size_t next = (use.corner + 1U) % 3U;
        const bool starts = mesh.triangles[use.triangle][use.corner] == vertex;
        return 3 * std::size_t{use.triangle} + (starts ? use.corner : next);
    };
    const bool low = corners.join(cornerAt(a, a.low), cornerAt(b, a.low));
    const bool high = corners.join(cornerAt(a, a.high), cornerAt(b, a.high));
    return (low ? 1U : 0U) + (high ? 1U : 0U);
}

/// Pieces that edges connect, and the genus by Euler's formula over all of them. A vertex where
/// several fans of triangles meet counts once for each fan, as if the surface were cut there.
void countPieces(MeshReport& report, const TriangleMesh& mesh, const EdgeTable& edges)
{
    const auto faces = static_cast<std::size_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                      [](const Triangle& t) { return !repeatsCorner(t); }));
    DisjointSets triangles(mesh.triangles.size());
    DisjointSets corners(3 * mesh.triangles.size());
    report.components = faces;
    std::size_t fans = 3 * faces;
    std::size_t edgeCount = 0;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            ++edgeCount;
            for (const EdgeUse& use : uses.subspan(1))
            {
                report.components -= triangles.join(uses[0].triangle, use.triangle) ? 1 : 0;
                fans -= joinCorners(corners, mesh, uses[0], use);
            }
        });
    const auto euler =
        static_cast<long>(fans) - static_cast<long>(edgeCount) + static_cast<long>(faces);
    report.genus = static_cast<int>(static_cast<long>(report.components) - euler / 2);
}

} // namespace

MeshReport inspectMesh(const TriangleMesh& mesh)
{
    return inspectMesh(mesh, EdgeTable(mesh));
}

MeshReport inspectMesh(const TriangleMesh& mesh, const EdgeTable& edges)
{
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.triangles = mesh.triangles.size();
    report.degenerateTriangles =
        static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                               [&](const Triangle& t) { return isFlat(mesh, t); }));
    report.unusedVertices = countUnused(mesh);

    report.duplicateTriangles = countDuplicates(mesh, edges);
    inspectEdges(report, mesh, edges);
    countPieces(report, mesh, edges);
    report.volume = signedVolume(mesh);
    report.area = surfaceArea(mesh);
    report.box = boundingBox(mesh);
    return report;
}

MeshReport inspectInterior(const TriangleMesh& mesh, MeshReport report, const Walls& walls,
                           Threads& threads)
{
    report.crossedTriangles = walls.crossed;
    report.firstCrossing = walls.firstCrossing;
    if (!walls.none())
    {
        report.volume = interiorVolume(mesh, threads);
    }
    return report;
}

MeshReport inspectInterior(const TriangleMesh& mesh, const MeshReport& report)
{
    const MeshIndex index(mesh);
    return inspectInterior(mesh, report, classifyWalls(mesh, index), *index.threads);
}

MeshReport inspectInterior(const TriangleMesh& mesh)
{
    const MeshIndex index(mesh);
    return inspectInterior(mesh, inspectMesh(mesh, index.edges), classifyWalls(mesh, index),
                           *index.threads);
}

namespace
{

// Areas are compared by their squares, fourth powers of lengths, which must not overflow.
constexpr double kLargestCoordinate = 1e70;

} // namespace

std::optional<std::string> findInvalidData(const TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        if (!mesh.vertices[i].allFinite())
        {
            return fmt::format("vertex {} is infinite or not a number", i + 1);
        }
        if (mesh.vertices[i].cwiseAbs().maxCoeff() > kLargestCoordinate)
        {
            return fmt::format("vertex {} has a coordinate beyond {:g}", i + 1, kLargestCoordinate);
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        for (const std::uint32_t corner : mesh.triangles[i])
        {
            if (corner >= mesh.vertices.size())
            {
                return fmt::format("triangle {} refers to vertex {} of {}", i + 1, corner + 1,
                                   mesh.vertices.size());
            }
        }
    }
    return std::nullopt;
}

} // namespace frostfill
