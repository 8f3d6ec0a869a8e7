// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"
#include "mesh/interior/triangle_grid.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Answers where a falling sphere has to look: a bit for each cell of two radii, set when a wall
/// or the centre of a sphere at rest is in it, stored by columns so that the next one below is
/// found in a few instructions.
class FallIndex
{
public:
    FallIndex(const GridFrame& frame, const TriangleGrid& triangles);

    void insert(const Eigen::Vector3d& centre);

    /// The highest layer of cells, at most y, with a sphere's centre in the column (x, z) or one of
    /// the eight around it: nothing else can touch a sphere with its centre in the column that
    /// comes down from layer y. -1 when there is none.
    [[nodiscard]] int highestSphere(int x, int z, int y) const;

    /// The highest layer, at most y, in which a wall may touch a sphere with its centre in the
    /// column (x, z).
    [[nodiscard]] int highestWall(int x, int z, int y) const
    {
        return highestBelow(x, z, y, walls_);
    }
    [[nodiscard]] const GridFrame& frame() const { return frame_; }

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
