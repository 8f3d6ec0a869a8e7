// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

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
        for (std::size_t begin = 0; begin < uses_.size();)
        {
            const std::size_t end = endOfEdge(begin);
            visit(std::span<const EdgeUse>(uses_.data() + begin, end - begin));
            begin = end;
        }
    }

    /// Uses of the edge between two vertices; empty if there is no such edge.
    [[nodiscard]] std::span<const EdgeUse> find(std::uint32_t a, std::uint32_t b) const;

    /// Number of edges that do not have exactly two triangles.
    [[nodiscard]] std::size_t badEdges() const;

private:
    [[nodiscard]] std::size_t endOfEdge(std::size_t begin) const;

    std::vector<EdgeUse> uses_;
};

} // namespace frostfill
