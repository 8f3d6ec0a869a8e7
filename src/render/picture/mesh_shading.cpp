// SPDX-License-Identifier: MIT
#include "render/picture/mesh_shading.hpp"

#include "mesh/connectivity.hpp"
#include "render/picture/mesh_creases.hpp"

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
/// [Thuermer & Wuethrich 1998], of those that are not bent away by a crease. Stray creases are
/// smoothed over: the noise of a scan would be seen as dots.
void smoothNormals(const TriangleMesh& mesh, ShadedMesh& shaded)
{
    std::vector<bool> creased(mesh.vertices.size());
    for (const ShadedMesh::Edge& edge : shaded.edges)
    {
        for (const std::uint32_t end : edge.ends)
        {
            creased[end] = creased[end] || (edge.crease != 0 && !edge.stray);
        }
    }
    shaded.normals.resize(mesh.triangles.size());
    std::vector<std::array<float, 3>> angles(mesh.triangles.size());
    for (std::size_t t = 0; t < angles.size(); ++t)
    {
        const std::array<glm::vec3, 3> corners = shaded.corners(t);
        angles[t] = {angleAt(corners, 0), angleAt(corners, 1), angleAt(corners, 2)};
    }
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
                if (!creased[vertex] || glm::dot(face, neighbour) >= kCreaseCosine)
                {
                    sum += neighbour * angles[other][cornerIn(other)];
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
    findEdges(mesh, shaded);
    if (fadingLines)
    {
        findStrayCreases(positions, shaded);
        shaded.creaseDistances = distancesFromCreases(mesh, positions, shaded.edges);
    }
    smoothNormals(mesh, shaded);
    return shaded;
}

EdgeStrengths::EdgeStrengths(const ShadedMesh& mesh)
    : mesh_(mesh), plain_(3 * mesh.triangles.size()), strengths_(mesh.triangles.size()),
      facesViewer_(mesh.triangles.size())
{
    for (const ShadedMesh::Edge& edge : mesh.edges)
    {
        const bool paired = edge.triangles[1] != ShadedMesh::Edge::kNone;
        std::array<Side, 2> sides{};
        for (std::size_t side = 0; side < (paired ? 2U : 1U); ++side)
        {
            sides[side] = 3 * edge.triangles[side] + edge.corners[side];
            plain_[sides[side]] = edge.stray ? kPlain : std::max(edge.crease, kPlain);
        }
        if (paired)
        {
            pairs_.push_back(sides);
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        offsets_.push_back(
            glm::dot(mesh.faceNormals[t], mesh.positions[mesh.triangles[t].front()]));
    }
    for (Side side = 0; side < plain_.size(); ++side)
    {
        strengths_[side / 3][side % 3] = plain_[side];
    }
}

const std::vector<std::array<std::uint8_t, 3>>& EdgeStrengths::from(const glm::vec3& eye,
                                                                    bool orthographic)
{
    for (std::size_t t = 0; t < facesViewer_.size(); ++t)
    {
        const float offset = orthographic ? 0 : offsets_[t];
        facesViewer_[t] = glm::dot(mesh_.faceNormals[t], eye) > offset ? 1 : 0;
    }
    for (const Side side : outline_)
    {
        strengths_[side / 3][side % 3] = plain_[side];
    }
    outline_.clear();
    for (const std::array<Side, 2>& pair : pairs_)
    {
        if (facesViewer_[pair[0] / 3] != facesViewer_[pair[1] / 3])
        {
            outline_.insert(outline_.end(), pair.begin(), pair.end());
        }
    }
    for (const Side side : outline_)
    {
        strengths_[side / 3][side % 3] = kOutline;
    }
    return strengths_;
}

std::vector<std::array<std::uint8_t, 3>> edgeStrengths(const ShadedMesh& mesh, const glm::vec3& eye,
                                                       bool orthographic)
{
    return EdgeStrengths(mesh).from(eye, orthographic);
}

} // namespace frostfill
