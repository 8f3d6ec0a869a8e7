// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <optional>

namespace frostfill
{
namespace
{

// [1] of the diagonal of the box: the rounding of file formats, and the cracks of careless export.
constexpr std::array<double, 4> kSeamDistances = {1e-6, 1e-5, 1e-4, 1e-3};
constexpr std::size_t kMaxStitches = 8;   // a triangle is split at one of its sides in each
constexpr std::size_t kSplitsPerEdge = 4; // more are no seam
constexpr std::size_t kSplitsAtLeast = 1000;

/// The vertices of rims, each as a triangle with no other corner.
TriangleMesh verticesOfRims(const TriangleMesh& mesh, const EdgeTable& edges)
{
    std::vector<bool> onRim(mesh.vertices.size(), false);
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 1)
            {
                onRim[uses[0].low] = onRim[uses[0].high] = true;
            }
        });
    TriangleMesh points{mesh.vertices, {}};
    for (std::uint32_t vertex = 0; vertex < onRim.size(); ++vertex)
    {
        if (onRim[vertex])
        {
            points.triangles.push_back({vertex, vertex, vertex});
        }
    }
    return points;
}

/// Merges vertices on the rims of holes that are closer than `distance`. Returns the number of
/// removed vertices.
std::size_t weldRims(TriangleMesh& mesh, double distance)
{
    const TriangleMesh rims = verticesOfRims(mesh, EdgeTable(mesh));
    const TriangleBvh tree(rims);
    DisjointSets sets(mesh.vertices.size());
    std::size_t gone = 0;
    for (const auto& [vertex, same, again] : rims.triangles)
    {
        const Eigen::Vector3d& p = mesh.vertices[vertex];
        const auto joinNear = [&, one = vertex](std::span<const std::uint32_t> points)
        {
            for (const std::uint32_t point : points)
            {
                const std::uint32_t other = rims.triangles[point][0];
                const bool isNear = (mesh.vertices[other] - p).norm() <= distance;
                gone += isNear && sets.join(other, one) ? 1 : 0;
            }
            return distance;
        };
        tree.forEachNear(Eigen::AlignedBox3d(p), distance, joinNear);
    }
    renumberCorners(mesh, [&](std::uint32_t corner) { return sets.find(corner); });
    return gone;
}

/// Vertices on the inner part of a side, in its direction.
std::vector<std::uint32_t> verticesOnSide(const TriangleMesh& mesh, const TriangleMesh& rims,
                                          const TriangleBvh& tree, const Triangle& t,
                                          std::size_t side, double distance)
{
    const Eigen::Vector3d& a = mesh.vertices[t[side]];
    const Eigen::Vector3d& b = mesh.vertices[t[(side + 1) % 3]];
    const double length = (b - a).norm();
    std::vector<std::pair<double, std::uint32_t>> found;
    if (length > 2 * distance)
    {
        const Eigen::Vector3d along = (b - a) / length;
        tree.forEachTriangleOnWay(a, b, distance,
                                  [&](std::uint32_t point)
                                  {
                                      const std::uint32_t vertex = rims.triangles[point][0];
                                      const Eigen::Vector3d arm = mesh.vertices[vertex] - a;
                                      const double where = arm.dot(along);
                                      if (where > distance && where < length - distance &&
                                          (arm - where * along).norm() <= distance &&
                                          vertex != t[(side + 2) % 3])
                                      {
                                          found.emplace_back(where, vertex);
                                      }
                                  });
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> vertices;
    double last = 0;
    for (const auto& [where, vertex] : found)
    {
        if (where > last + distance) // not two at one place
        {
            vertices.push_back(vertex);
            last = where;
        }
    }
    return vertices;
}

/// Splits each triangle at one of its open sides. Returns nothing if that takes more than `most`.
std::optional<std::size_t> splitOnce(TriangleMesh& mesh, double distance, std::size_t most)
{
    const EdgeTable edges(mesh);
    const TriangleMesh rims = verticesOfRims(mesh, edges);
    const TriangleBvh tree(rims);
    std::vector<bool> touched(mesh.triangles.size(), false);
    std::size_t count = 0;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const EdgeUse& use = uses[0];
            if (uses.size() != 1 || touched[use.triangle] || count > most)
            {
                return;
            }
            const Triangle t = mesh.triangles[use.triangle];
            const auto vertices = verticesOnSide(mesh, rims, tree, t, use.corner, distance);
            if (vertices.empty())
            {
                return;
            }
            touched[use.triangle] = true;
            count += vertices.size();
            const std::uint32_t tip = t[(use.corner + 2U) % 3U];
            mesh.triangles[use.triangle] = {t[use.corner], vertices[0], tip};
            for (std::size_t i = 0; i < vertices.size(); ++i)
            {
                const std::uint32_t next =
                    i + 1 < vertices.size() ? vertices[i + 1] : t[(use.corner + 1U) % 3U];
                mesh.triangles.push_back({vertices[i], next, tip});
            }
        });
    return count > most ? std::nullopt : std::optional(count);
}

struct Openness
{
    std::size_t open = 0; ///< edges of one triangle
    std::size_t bad = 0;  ///< edges that do not have two
};

Openness opennessOf(const TriangleMesh& mesh)
{
    Openness result;
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            result.open += uses.size() == 1 ? 1 : 0;
            result.bad += uses.size() != 2 ? 1 : 0;
        });
    return result;
}

std::size_t countCollapsed(const TriangleMesh& mesh)
{
    return static_cast<std::size_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(), repeatsCorner));
}

} // namespace

std::size_t splitAtTJunctions(TriangleMesh& mesh, double distance)
{
    const std::size_t most = kSplitsAtLeast + kSplitsPerEdge * opennessOf(mesh).open;
    TriangleMesh split = mesh;
    std::size_t sum = 0;
    for (std::size_t pass = 0; pass < kMaxStitches; ++pass)
    {
        const auto count = splitOnce(split, distance, most - sum);
        if (!count)
        {
            return 0;
        }
        sum += *count;
        if (*count == 0)
        {
            break;
        }
    }
    if (sum > 0)
    {
        mesh = std::move(split);
    }
    return sum;
}

std::vector<std::string> stitchSeams(TriangleMesh& mesh)
{
    std::vector<std::string> repairs;
    const double size = boundingBox(mesh).diagonal().norm();
    Openness now = opennessOf(mesh);
    const auto keepIfBetter = [&](TriangleMesh&& stitched, double share, std::size_t joined,
                                  std::size_t split, bool mustClose)
    {
        const Openness then = opennessOf(stitched);
        if (then.bad >= now.bad || (mustClose && then.open > 0))
        {
            return;
        }
        mesh = std::move(stitched);
        now = then;
        if (joined > 0)
        {
            repairs.push_back(fmt::format("joined {} vert{} along open seams to others closer than "
                                          "{:g} of the object's size",
                                          joined, joined == 1 ? "ex" : "ices", share));
        }
        if (split > 0)
        {
            repairs.push_back(
                fmt::format("split open edges at {} vert{} of their neighbours that lay on them",
                            split, split == 1 ? "ex" : "ices"));
        }
    };
    TriangleMesh welded = mesh;
    const std::size_t joined = weldRims(welded, kSeamDistances[0] * size);
    keepIfBetter(std::move(welded), kSeamDistances[0], joined, 0, false);
    TriangleMesh split = mesh;
    const std::size_t splits = splitAtTJunctions(split, kSeamDistances[0] * size);
    keepIfBetter(std::move(split), kSeamDistances[0], 0, splits, false);
    for (std::size_t i = 1; i < kSeamDistances.size() && now.open > 0; ++i)
    {
        TriangleMesh wide = mesh;
        const std::size_t wideJoined = weldRims(wide, kSeamDistances[i] * size);
        // Small triangles beside a wide seam must not vanish in it.
        if (wideJoined > 0 && countCollapsed(wide) <= countCollapsed(mesh))
        {
            const std::size_t wideSplits = splitAtTJunctions(wide, kSeamDistances[i] * size);
            keepIfBetter(std::move(wide), kSeamDistances[i], wideJoined, wideSplits, true);
        }
    }
    return repairs;
}

namespace
{

/// Of the bits of a position; +0 and -0 are equal.
std::uint64_t hashOf(const Eigen::Vector3d& position)
{
    std::uint64_t hash = 0;
    for (const double coordinate : position)
    {
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29;
    }
    return hash;
}

} // namespace

// With open addressing: a table of numbers, in which a vertex stands where its hash says or behind.
void weldEqualVertices(TriangleMesh& mesh)
{
    constexpr std::uint32_t kFree = 0xffffffff;
    const std::size_t mask = std::bit_ceil(2 * mesh.vertices.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, kFree);
    std::vector<std::uint32_t> place;
    place.reserve(mesh.vertices.size());
    std::uint32_t kept = 0;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        std::size_t slot = hashOf(vertex) & mask;
        while (table[slot] != kFree && mesh.vertices[table[slot]] != vertex)
        {
            slot = (slot + 1) & mask;
        }
        if (table[slot] == kFree)
        {
            mesh.vertices[kept] = vertex;
            table[slot] = kept++;
        }
        place.push_back(table[slot]);
    }
    mesh.vertices.resize(kept);
    renumberCorners(mesh, [&](std::uint32_t corner) { return place[corner]; });
}

} // namespace frostfill
