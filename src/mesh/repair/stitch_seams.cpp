// SPDX-License-Identifier: MIT
#include "mesh/repair/stitch_seams.hpp"

#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>

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
    const std::vector<bool> onRim = verticesOnRims(mesh, edges);
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

std::string sayJoined(std::size_t count, double share)
{
    return fmt::format("joined {} vert{} along open seams to others closer than {:g} of the "
                       "object's size",
                       count, count == 1 ? "ex" : "ices", share);
}

std::string saySplit(std::size_t count)
{
    return fmt::format("split open edges at {} vert{} of their neighbours that lay on them", count,
                       count == 1 ? "ex" : "ices");
}

/// Keeps a repaired copy and its sentence if it has fewer bad edges.
void keepIfBetter(TriangleMesh& mesh, Openness& now, TriangleMesh&& repaired, std::string sentence,
                  std::vector<std::string>& repairs)
{
    const Openness then = opennessOf(repaired);
    if (then.bad < now.bad)
    {
        mesh = std::move(repaired);
        now = then;
        repairs.push_back(std::move(sentence));
    }
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
    {
        TriangleMesh welded = mesh;
        const std::size_t count = weldRims(welded, kSeamDistances[0] * size);
        if (count > 0)
        {
            keepIfBetter(mesh, now, std::move(welded), sayJoined(count, kSeamDistances[0]),
                         repairs);
        }
    }
    if (now.open > 0)
    {
        TriangleMesh split = mesh;
        const std::size_t count = splitAtTJunctions(split, kSeamDistances[0] * size);
        if (count > 0)
        {
            keepIfBetter(mesh, now, std::move(split), saySplit(count), repairs);
        }
    }
    for (std::size_t i = 1; i < kSeamDistances.size() && now.open > 0; ++i)
    {
        TriangleMesh wide = mesh;
        const std::size_t joined = weldRims(wide, kSeamDistances[i] * size);
        // Small triangles beside a wide seam must not vanish in it.
        if (joined == 0 || countCollapsed(wide) > countCollapsed(mesh))
        {
            continue;
        }
        const std::size_t split = splitAtTJunctions(wide, kSeamDistances[i] * size);
        const Openness then = opennessOf(wide);
        if (then.open > 0 || then.bad >= now.bad)
        {
            continue;
        }
        mesh = std::move(wide);
        now = then;
        repairs.push_back(sayJoined(joined, kSeamDistances[i]));
        if (split > 0)
        {
            repairs.push_back(saySplit(split));
        }
    }
    return repairs;
}

namespace
{

using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
    std::size_t operator()(const Cell& cell) const
    {
        std::uint64_t hash = 0;
        for (const std::int64_t value : cell)
        {
            hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// The bits of a position; +0 and -0 are equal.
Cell bitsOf(const Eigen::Vector3d& position)
{
    Cell bits;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        bits[axis] = std::bit_cast<std::int64_t>(position[static_cast<int>(axis)] + 0.0);
    }
    return bits;
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
        std::size_t slot = CellHash()(bitsOf(vertex)) & mask;
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
    for (auto& triangle : mesh.triangles)
    {
        for (std::uint32_t& corner : triangle)
        {
            corner = place[corner];
        }
    }
}

std::vector<bool> verticesOnRims(const TriangleMesh& mesh, const EdgeTable& edges)
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
    return onRim;
}

std::size_t weldRims(TriangleMesh& mesh, double distance)
{
    const std::vector<bool> onRim = verticesOnRims(mesh, EdgeTable(mesh));
    const Eigen::Vector3d origin = boundingBox(mesh).min();
    const auto cellOf = [&](std::size_t vertex)
    {
        Cell cell;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const auto i = static_cast<int>(axis);
            cell[axis] = std::llround((mesh.vertices[vertex][i] - origin[i]) / distance);
        }
        return cell;
    };

    std::unordered_map<Cell, std::vector<std::size_t>, CellHash> grid;
    DisjointSets sets(mesh.vertices.size());
    std::size_t gone = 0;
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    {
        if (!onRim[vertex])
        {
            continue;
        }
        const Cell cell = cellOf(vertex);
        for (int neighbour = 0; neighbour < 27; ++neighbour)
        {
            const auto found =
                grid.find({cell[0] + neighbour % 3 - 1, cell[1] + neighbour / 3 % 3 - 1,
                           cell[2] + neighbour / 9 - 1});
            if (found == grid.end())
            {
                continue;
            }
            for (const std::size_t other : found->second)
            {
                if (sets.find(other) != sets.find(vertex) &&
                    (mesh.vertices[other] - mesh.vertices[vertex]).norm() <= distance)
                {
                    sets.join(other, vertex);
                    ++gone;
                }
            }
        }
        grid[cell].push_back(vertex);
    }
    for (auto& triangle : mesh.triangles)
    {
        for (std::uint32_t& corner : triangle)
        {
            corner = static_cast<std::uint32_t>(sets.find(corner));
        }
    }
    return gone;
}

} // namespace frostfill
