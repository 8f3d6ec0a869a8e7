// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
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
    /// The word of a cell, which has one from now on.
    std::size_t wordOf(const GridPlace& cell);
    [[nodiscard, gnu::noinline]] int highestInBricks(int x, int z, int y,
                                                     const std::vector<std::uint64_t>& bits) const;
    [[nodiscard]] int highestBelow(int x, int z, int y,
                                   const std::vector<std::uint64_t>& bits) const;

    GridFrame frame_;
    BrickedCells<1> words_;              ///< of 64 cells each, by their layer, x and z
    std::vector<std::uint64_t> spheres_; ///< [#words_]
    std::vector<std::uint64_t> walls_;   ///< [#words_]
};

} // namespace frostfill
