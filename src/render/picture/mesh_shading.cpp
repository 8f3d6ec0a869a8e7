// SPDX-License-Identifier: MIT
#include "render/picture/mesh_shading.hpp"

#include "mesh/connectivity.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

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

/// Triangles of a simplified mesh that are tilted by more than 15 degrees are slivers.
constexpr float kTiltedCosine = 0.966F;

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
/// smoothed over: the noise of a scan would be seen as dots. Splits vertices so that each has one
/// normal. `distances` from creases are those of the mesh's vertices, or empty.
void smoothNormals(const TriangleMesh& mesh, const std::vector<float>& distances,
                   ShadedMesh& shaded)
{
    std::vector<bool> creased(mesh.vertices.size());
    for (const ShadedMesh::Edge& edge : shaded.edges)
    {
        for (const std::uint32_t end : edge.ends)
        {
            creased[end] = creased[end] || (edge.crease != 0 && !edge.stray);
        }
    }
    std::vector<std::array<float, 3>> angles(mesh.triangles.size());
    for (std::size_t t = 0; t < angles.size(); ++t)
    {
        const std::array<glm::vec3, 3> corners = shaded.corners(t);
        angles[t] = {angleAt(corners, 0), angleAt(corners, 1), angleAt(corners, 2)};
    }
    const VertexTriangles around(mesh);
    std::vector<glm::vec3> positions; // of the vertices that are split
    for (std::uint32_t vertex = 0; vertex < around.vertices(); ++vertex)
    {
        const auto first = static_cast<std::ptrdiff_t>(positions.size());
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
            const glm::vec3 normal = sum == glm::vec3(0) ? face : unitOrZero(sum);
            auto& normals = shaded.normals;
            const auto index =
                std::find(normals.begin() + first, normals.end(), normal) - normals.begin();
            if (index == std::ssize(normals))
            {
                positions.push_back(shaded.positions[vertex]);
                normals.push_back(normal);
                if (!distances.empty())
                {
                    shaded.creaseDistances.push_back(distances[vertex] / kCreaseReach);
                }
            }
            for (std::size_t corner = 0; corner < 3; ++corner)
            {
                if (mesh.triangles[own][corner] == vertex)
                {
                    shaded.triangles[own][corner] = static_cast<std::uint32_t>(index);
                }
            }
        }
    }
    shaded.positions = std::move(positions);
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

/// Creases that hang together and are shorter than this in all are stray. [unit space]
constexpr float kShortestCrease = 0.08F;

/// So are those of many short edges [unit space] that are a little longer, or are not bent much: a
/// rim that is round, but too narrow for its mesh.
constexpr float kFine = 0.03F;
constexpr float kShortestFineCrease = 0.3F;
constexpr float kMinOfFine = 0.5F * (line_strength::kPlain + line_strength::kStrong);

/// And so are those that branch at more than one of so many edges: noise of a scan that hangs
/// together.
constexpr float kEdgesPerKnot = 4;

bool isCrease(const ShadedMesh::Edge& edge)
{
    return edge.crease != 0 && !edge.stray;
}

float distanceToSegment(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 along = b - a;
    const float squared = glm::dot(along, along);
    const float share =
        squared > 0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0F, 1.0F) : 0.0F;
    return glm::distance(point, a + share * along);
}

/// Distance of every vertex from the nearest crease, at most kCreaseReach; empty if there is none.
/// Where triangles are smaller than a line is wide, the line runs over more than those on either
/// side of its edge, which have to know how far it is. Each vertex that is reached asks its
/// neighbours whether the crease nearest to it is nearest to them too.
std::vector<float> distancesFromCreases(const TriangleMesh& mesh,
                                        const std::vector<glm::vec3>& positions,
                                        const std::vector<ShadedMesh::Edge>& edges)
{
    if (std::none_of(edges.begin(), edges.end(), isCrease))
    {
        return {};
    }
    using Arrival = std::tuple<float, std::uint32_t, std::uint32_t>; // distance, vertex, crease
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals;
    std::vector<float> distances(positions.size(), kCreaseReach);
    const auto reach = [&](std::uint32_t vertex, std::uint32_t crease)
    {
        const auto& [a, b] = edges[crease].ends;
        const float distance = distanceToSegment(positions[vertex], positions[a], positions[b]);
        if (distance < distances[vertex])
        {
            distances[vertex] = distance;
            arrivals.emplace(distance, vertex, crease);
        }
    };
    for (std::uint32_t i = 0; i < edges.size(); ++i)
    {
        if (isCrease(edges[i]))
        {
            reach(edges[i].ends[0], i);
            reach(edges[i].ends[1], i);
        }
    }
    const VertexTriangles around(mesh);
    while (!arrivals.empty())
    {
        const auto [distance, vertex, crease] = arrivals.top();
        arrivals.pop();
        for (const std::uint32_t triangle : around.at(vertex))
        {
            for (const std::uint32_t neighbour : mesh.triangles[triangle])
            {
                if (distance == distances[vertex]) // nothing nearer has come since
                {
                    reach(neighbour, crease);
                }
            }
        }
    }
    return distances;
}

/// Marks creases that hang together with few others: where a scan is rough, single edges are bent
/// as much as those of a box. `positions` are the mesh's vertices in unit space.
void findStrayCreases(const std::vector<glm::vec3>& positions, ShadedMesh& shaded)
{
    DisjointSets joined(positions.size());
    std::vector<std::uint32_t> degrees(positions.size());
    for (const ShadedMesh::Edge& edge : shaded.edges)
    {
        if (edge.crease != 0)
        {
            ++degrees[edge.ends[0]];
            ++degrees[edge.ends[1]];
            joined.join(edge.ends[0], edge.ends[1]);
        }
    }
    struct Chain
    {
        float edges = 0, length = 0, strength = 0; ///< the last one over the length
        float knots = 0;                           ///< where three edges meet, or more
    };
    std::vector<Chain> chains(positions.size());
    for (const ShadedMesh::Edge& edge : shaded.edges)
    {
        if (edge.crease != 0)
        {
            const float length = glm::distance(positions[edge.ends[0]], positions[edge.ends[1]]);
            Chain& chain = chains[joined.find(edge.ends[0])];
            chain.edges += 1;
            chain.length += length;
            chain.strength += length * edge.crease;
            for (const std::uint32_t end : edge.ends)
            {
                chain.knots += degrees[end] > 2 ? 1.0F / static_cast<float>(degrees[end]) : 0.0F;
            }
        }
    }
    for (ShadedMesh::Edge& edge : shaded.edges)
    {
        if (edge.crease != 0)
        {
            const Chain& chain = chains[joined.find(edge.ends[0])];
            const bool fine = chain.length < kFine * chain.edges;
            edge.stray = chain.length < (fine ? kShortestFineCrease : kShortestCrease) ||
                         (fine && (chain.strength < kMinOfFine * chain.length ||
                                   kEdgesPerKnot * chain.knots > chain.edges));
        }
    }
}

} // namespace

ShadedMesh shadeMesh(const TriangleMesh& mesh, const std::vector<glm::vec3>& positions,
                     bool fadingLines, std::span<const glm::vec3> trueNormals)
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
    for (std::size_t t = 0; t < trueNormals.size(); ++t)
    {
        // Simplifying leaves slivers, whose own normals say nothing of the surface.
        if (glm::dot(shaded.faceNormals[t], trueNormals[t]) < kTiltedCosine)
        {
            shaded.faceNormals[t] = trueNormals[t];
        }
    }
    findEdges(mesh, shaded);
    std::vector<float> distances;
    if (fadingLines)
    {
        findStrayCreases(positions, shaded);
        distances = distancesFromCreases(mesh, positions, shaded.edges);
    }
    smoothNormals(mesh, distances, shaded);
    return shaded;
}

std::vector<std::array<std::uint8_t, 3>> edgeStrengths(const ShadedMesh& mesh, const glm::vec3& eye,
                                                       bool orthographic)
{
    std::vector<bool> facesViewer(mesh.triangles.size());
    for (std::size_t t = 0; t < facesViewer.size(); ++t)
    {
        const glm::vec3& corner = mesh.positions[mesh.triangles[t].front()];
        const float offset = orthographic ? 0 : glm::dot(mesh.faceNormals[t], corner);
        facesViewer[t] = glm::dot(mesh.faceNormals[t], eye) > offset;
    }
    std::vector<std::array<std::uint8_t, 3>> strengths(mesh.triangles.size());
    for (const ShadedMesh::Edge& edge : mesh.edges)
    {
        const auto& [first, second] = edge.triangles;
        const bool paired = second != ShadedMesh::Edge::kNone;
        const bool outline = paired && facesViewer[first] != facesViewer[second];
        const std::uint8_t strength = outline      ? kOutline
                                      : edge.stray ? kPlain
                                                   : std::max(edge.crease, kPlain);
        for (std::size_t side = 0; side < (paired ? 2U : 1U); ++side)
        {
            strengths[edge.triangles[side]][edge.corners[side]] = strength;
        }
    }
    return strengths;
}

} // namespace frostfill
