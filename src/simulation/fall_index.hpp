// SPDX-License-Identifier: MIT
#pragma once

#include <geometry/grid_frame.hpp>
#include <mesh/triangle_grid.hpp>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Answers how far a sphere can fall before it is worth looking: a bit for each cell of two radii,
/// set when a wall or the centre of a sphere at rest is in it, stored by columns so that the next
/// one below is found in a few instructions.
class FallIndex
{
public:
    FallIndex(const GridFrame& frame, const TriangleGrid& triangles);

    void insert(const Eigen::Vector3d& centre);

    /// The height down to which a sphere at p with a radius of at most 1 can fall without touching
    /// anything; p's own height when something may be near.
    [[nodiscard]] double freeHeight(const Eigen::Vector3d& p) const;

private:
    [[nodiscard]] std::size_t column(int x, int z) const
    {
        return (static_cast<std::size_t>(z) * frame_.count[0] + x) * words_;
    }
    [[nodiscard]] int highestBelow(int x, int z, int y,
                                   const std::vector<std::uint64_t>& bits) const;

    GridFrame frame_;
    std::size_t words_; ///< of 64 cells in a column
    std::vector<std::uint64_t> spheres_;
    std::vector<std::uint64_t> walls_;
};

} // namespace frostfill
