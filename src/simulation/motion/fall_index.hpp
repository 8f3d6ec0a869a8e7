// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/triangle_grid.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <bit>
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
    /// With the levels of a grid of spheres.
    FallIndex(const SphereGrid& spheres, const TriangleGrid& triangles);

    /// `level`: that of the sphere's radius.
    void insert(const Eigen::Vector3d& centre, std::size_t level = 0);

    /// The highest layer of cells, at most y, with a sphere's centre in the column (x, z) or one of
    /// the eight around it: nothing else can touch a sphere with its centre in the column that
    /// comes down from layer y. -1 when there is none.
    [[nodiscard]] int highestSphere(int x, int z, int y) const;

    /// The same of a level: in the column (x, z) or one of those around it that are at most
    /// `beside` away.
    [[nodiscard]] int highestSphere(int x, int z, int y, std::size_t level, int beside) const;

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
    /// The highest bit, at most y, of a column whose words are asked for by their number, down to
    /// the word `last`.
    template <class WordAt>
    [[nodiscard]] static int highestIn(int y, WordAt&& wordAt, int last = 0)
    {
        int index = y / 64;
        std::uint64_t candidates = wordAt(index) & (~std::uint64_t{0} >> (63 - y % 64));
        while (candidates == 0 && index > last)
        {
            candidates = wordAt(--index);
        }
        return candidates == 0 ? -1 : index * 64 + 63 - std::countl_zero(candidates);
    }
    // Inlined for a grid of one brick, as nearly always.
    [[nodiscard]] int highestBelow(int x, int z, int y,
                                   const std::vector<std::uint64_t>& bits) const
    {
        if (!words_.isOne()) [[unlikely]]
        {
            return highestInBricks(x, z, y, bits);
        }
        const std::uint64_t* column = bits.data() + words_.find(0, x, z);
        return highestIn(y, [column](int index) { return column[index]; });
    }

    GridFrame frame_;
    BrickedCells<1> words_;              ///< of 64 cells each, by their layer, x and z
    std::vector<std::uint64_t> spheres_; ///< [#words_]
    std::vector<std::uint64_t> walls_;   ///< [#words_]
    /// Of spheres of a finer level.
    struct Level
    {
        GridFrame frame;
        BrickedCells<1> words;
        std::vector<std::uint64_t> spheres; ///< [#words]
    };
    std::vector<Level> finer_;
};

} // namespace frostfill
