// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "mesh/triangle_shape.hpp"

#include <frostfill/mesh.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

/// The connections of a mesh: over edges, over vertices, and into connected sets.
namespace frostfill
{

/// A side of a triangle. Sides with the same two vertices are uses of one edge.
struct EdgeUse
{
    std::uint32_t low = 0;  ///< vertex
    std::uint32_t high = 0; ///< vertex, above low
    std::uint32_t triangle = 0;
    std::uint8_t corner = 0; ///< of the triangle, where the side starts
    bool forward = false;    ///< the side runs from low to high
};

/// Whether as many triangles pass an edge in one direction as in the other.
[[nodiscard]] bool cancels(std::span<const EdgeUse> uses);

/// All edges of a mesh, each with its triangles in ascending order; ordered by vertex numbers.
/// Triangles that repeat a corner have no edges.
class EdgeTable
{
public:
    explicit EdgeTable(const TriangleMesh& mesh);

    /// Calls `visit(std::span<const EdgeUse>)` for each edge.
    template <typename Visit>
    void forEach(Visit&& visit) const
    {
        std::array<EdgeUse, 2> two; // as nearly always
        std::vector<EdgeUse> more;
        for (std::uint32_t low = 0; low < sides_.size(); ++low)
        {
            const std::span<const Side> sides = sides_[low];
            for (std::size_t side = 0; side < sides.size();)
            {
                const std::size_t first = side++;
                while (side < sides.size() && highOf(sides[side]) == highOf(sides[first]))
                {
                    ++side;
                }
                const std::size_t count = side - first;
                more.resize(count > 2 ? count : 0);
                EdgeUse* uses = count > 2 ? more.data() : two.data();
                for (std::size_t k = 0; k < count; ++k)
                {
                    uses[k] = unpacked(low, sides[first + k]);
                }
                visit(std::span<const EdgeUse>(uses, count));
            }
        }
    }

    /// Uses of the edge between two vertices; empty if there is no such edge.
    [[nodiscard]] std::vector<EdgeUse> find(std::uint32_t a, std::uint32_t b) const;

private:
    /// A side in 64 bits: its higher vertex, its number 3 x triangle + corner, and whether it runs
    /// forward. In this order they sort as they have to. A mesh of scans has millions.
    using Side = std::uint64_t;
    [[nodiscard]] static std::uint32_t highOf(Side side)
    {
        return static_cast<std::uint32_t>(side >> 32);
    }
    [[nodiscard]] static EdgeUse unpacked(std::uint32_t low, Side side)
    {
        const auto number = static_cast<std::uint32_t>(side) >> 1;
        return {low, highOf(side), number / 3, static_cast<std::uint8_t>(number % 3),
                (side & 1) != 0};
    }

    Buckets<Side> sides_; ///< by lower vertex, sorted
};

/// The triangles at each vertex, ascending. A triangle that repeats a corner is at none.
class VertexTriangles
{
public:
    explicit VertexTriangles(const TriangleMesh& mesh)
        : triangles_(mesh.vertices.size(),
                     [&](auto&& enter)
                     {
                         for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
                         {
                             const Triangle& corners = mesh.triangles[t];
                             for (std::size_t k = 0; k < 3 && !repeatsCorner(corners); ++k)
                             {
                                 enter(corners[k], t);
                             }
                         }
                     })
    {
    }

    [[nodiscard]] std::size_t vertices() const { return triangles_.size(); }
    [[nodiscard]] std::span<const std::uint32_t> at(std::size_t vertex) const
    {
        return triangles_[vertex];
    }

private:
    Buckets<std::uint32_t> triangles_;
};

/// Disjoint sets of numbers. The smallest number represents its set.
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::size_t find(std::size_t i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    /// Whether the two were apart.
    bool join(std::size_t i, std::size_t j)
    {
        i = find(i);
        j = find(j);
        parent_[i < j ? j : i] = static_cast<std::uint32_t>(i < j ? i : j);
        return i != j;
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// The triangles of a mesh with so many, connected over the edges for which joins(uses) holds.
template <class Joins>
[[nodiscard]] DisjointSets connectedOver(const EdgeTable& edges, std::size_t triangles,
                                         Joins&& joins)
{
    DisjointSets sets(triangles);
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (const EdgeUse& use : uses.subspan(joins(uses) ? 1 : uses.size()))
            {
                sets.join(uses[0].triangle, use.triangle);
            }
        });
    return sets;
}

} // namespace frostfill
