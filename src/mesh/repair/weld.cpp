// SPDX-License-Identifier: MIT
#include "mesh/repair/weld.hpp"

#include "mesh/repair/components.hpp"

#include <bit>
#include <cmath>
#include <unordered_map>

namespace frostfill
{
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
