// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// For each side of a triangle, the side of the neighbour that runs the other way. Side k of
/// triangle t has the number 3 t + k and runs from corner k to corner k + 1.
class EdgeTwins
{
public:
    /// In place of a twin at an edge that has not exactly two sides, one in each direction.
    static constexpr std::uint32_t kNone = 0xffffffff;

    explicit EdgeTwins(const EdgeTable& edges);

    [[nodiscard]] std::uint32_t operator[](std::size_t side) const { return twins_[side]; }

    /// Whether the triangles at a vertex form one closed fan. If not, the surface touches itself
    /// there, or has an edge without twins.
    [[nodiscard]] bool isOneFan(const TriangleMesh& mesh, std::uint32_t vertex,
                                std::span<const std::uint32_t> triangles) const;

private:
    std::vector<std::uint32_t> twins_; ///< [3 #T]
};

} // namespace frostfill
