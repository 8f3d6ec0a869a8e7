// SPDX-License-Identifier: MIT
#include "render/picture/mesh_creases.hpp"

#include "mesh/connectivity.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <queue>
#include <tuple>

namespace frostfill
{
namespace
{

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

/// Distance of every vertex from the nearest crease, at most kCreaseReach: each vertex that is
/// reached asks its neighbours whether the crease nearest to it is nearest to them too.
std::vector<float> spread(const TriangleMesh& mesh, const std::vector<glm::vec3>& positions,
                          const std::vector<ShadedMesh::Edge>& edges)
{
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

} // namespace

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

std::vector<std::array<float, 3>> distancesFromCreases(const TriangleMesh& mesh,
                                                       const std::vector<glm::vec3>& positions,
                                                       const std::vector<ShadedMesh::Edge>& edges)
{
    if (std::none_of(edges.begin(), edges.end(), isCrease))
    {
        return {};
    }
    const std::vector<float> distances = spread(mesh, positions, edges);
    std::vector<std::array<float, 3>> ofCorners;
    ofCorners.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
    {
        ofCorners.push_back({distances[a] / kCreaseReach, distances[b] / kCreaseReach,
                             distances[c] / kCreaseReach});
    }
    return ofCorners;
}

} // namespace frostfill
