// SPDX-License-Identifier: MIT
#include "render/passes/mesh_shading.hpp"

#include "mesh/edge_table.hpp"
#include "mesh/vertex_triangles.hpp"
#include "render/passes/mesh_creases.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
using namespace line_strength;

namespace
{

/// Edges that are bent by more than 35 degrees are drawn, and not smoothed over. A round thing of
/// twelve sides, which bends by 30, is meant to be smooth.
constexpr float kCreaseCosine = 0.819F;

/// A crease is drawn in full from a bend of 65 degrees on.
constexpr float kSharpCosine = 0.423F;

/// How strongly a crease between two faces is drawn; 0 when they go smoothly into each other.
std::uint8_t creaseStrength(const glm::vec3& a, const glm::vec3& b)
{
    const float cosine = glm::dot(a, b);
    if (cosine >= kCreaseCosine)
    {
        return 0;
    }
    const float sharpness =
        std::min((kCreaseCosine - cosine) / (kCreaseCosine - kSharpCosine), 1.0F);
    return static_cast<std::uint8_t>(std::lround(kPlain + sharpness * (kStrong - kPlain)));
}

glm::vec3 unitOrZero(const glm::vec3& v)
{
    const float length = glm::length(v);
    return length > 0 ? v / length : glm::vec3(0);
}

float angleAt(const std::array<glm::vec3, 3>& triangle, std::size_t corner)
{
    const glm::vec3 a = unitOrZero(triangle[(corner + 1) % 3] - triangle[corner]);
    const glm::vec3 b = unitOrZero(triangle[(corner + 2) % 3] - triangle[corner]);
    return std::acos(std::clamp(glm::dot(a, b), -1.0F, 1.0F));
}

/// Sum over the triangles around each corner's vertex, weighted by their angle there
/// [Thuermer & Wuethrich 1998], of those that are not bent away by a crease.
void smoothNormals(const TriangleMesh& mesh, ShadedMesh& shaded)
{
    shaded.normals.resize(mesh.triangles.size());
    const VertexTriangles around(mesh);
    for (std::uint32_t vertex = 0; vertex < around.vertices(); ++vertex)
    {
        const auto cornerIn = [&](std::uint32_t t)
        {
            const auto& corners = mesh.triangles[t];
            return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) -
                                            corners.begin());
        };
        for (const std::uint32_t own : around.at(vertex))
        {
            const glm::vec3& face = shaded.faceNormals[own];
            glm::vec3 sum(0);
            for (const std::uint32_t other : around.at(vertex))
            {
                const glm::vec3& neighbour = shaded.faceNormals[other];
                if (glm::dot(face, neighbour) >= kCreaseCosine)
                {
                    sum += neighbour * angleAt(shaded.corners(other), cornerIn(other));
                }
            }
            shaded.normals[own][cornerIn(own)] = sum == glm::vec3(0) ? face : unitOrZero(sum);
        }
    }
}

void findEdges(const TriangleMesh& mesh, ShadedMesh& shaded)
{
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (std::size_t first = 0; first < uses.size(); first += 2) // they go in pairs
            {
                const auto pair =
                    uses.subspan(first, std::min<std::size_t>(2, uses.size() - first));
                ShadedMesh::Edge edge;
                edge.ends = {pair[0].low, pair[0].high};
                edge.crease = kStrong;
                for (std::size_t side = 0; side < pair.size(); ++side)
                {
                    edge.triangles[side] = pair[side].triangle;
                    edge.corners[side] = static_cast<std::uint8_t>((pair[side].corner + 2) % 3);
                }
                if (pair.size() == 2)
                {
                    edge.crease = creaseStrength(shaded.faceNormals[edge.triangles[0]],
                                                 shaded.faceNormals[edge.triangles[1]]);
                }
                shaded.edges.push_back(edge);
            }
        });
}

} // namespace

ShadedMesh shadeMesh(const TriangleMesh& mesh, const std::vector<glm::vec3>& positions,
                     bool fadingLines)
{
    ShadedMesh shaded;
    shaded.positions = positions;
    shaded.triangles = mesh.triangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const std::array<glm::vec3, 3> corners = shaded.corners(t);
        shaded.faceNormals.push_back(
            unitOrZero(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
    }
    smoothNormals(mesh, shaded);
    findEdges(mesh, shaded);
    if (fadingLines)
    {
        findStrayCreases(positions, shaded);
        shaded.creaseDistances = distancesFromCreases(mesh, positions, shaded.edges);
    }
    return shaded;
}

std::vector<std::array<std::uint8_t, 3>> edgeStrengths(const ShadedMesh& mesh, const glm::vec3& eye,
                                                       bool orthographic)
{
    std::vector<std::uint8_t> facesViewer(mesh.triangles.size());
    for (std::size_t t = 0; t < facesViewer.size(); ++t)
    {
        const glm::vec3 towards =
            orthographic ? eye : eye - mesh.positions[mesh.triangles[t].front()];
        facesViewer[t] = glm::dot(mesh.faceNormals[t], towards) > 0 ? 1 : 0;
    }
    std::vector<std::array<std::uint8_t, 3>> strengths(mesh.triangles.size());
    for (const ShadedMesh::Edge& edge : mesh.edges)
    {
        const bool paired = edge.triangles[1] != ShadedMesh::Edge::kNone;
        const bool outline =
            paired && facesViewer[edge.triangles[0]] != facesViewer[edge.triangles[1]];
        const std::uint8_t crease = edge.stray ? kPlain : std::max(edge.crease, kPlain);
        const std::uint8_t strength = outline ? kOutline : crease;
        for (std::size_t side = 0; side < (paired ? 2U : 1U); ++side)
        {
            strengths[edge.triangles[side]][edge.corners[side]] = strength;
        }
    }
    return strengths;
}

} // namespace frostfill
