// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// A set of cubes of a grid, one bit each, in the order of a VoxelLayout.
using VoxelBits = std::vector<std::uint64_t>;

/// Some cubes of one row: bit i of word `word`.
struct VoxelWord
{
    std::size_t word;
    std::uint64_t bits;
};

/// How the cubes of a grid are packed into words: rows run along x, planes lie level. Every row
/// ends in a bit that is never set, every plane in a row and the whole in planes that are never
/// set, so that the neighbours of any word are found by adding to its number and nothing is
/// compared with the border.
struct VoxelLayout
{
    GridFrame frame;
    std::size_t wordsPerRow = 1;
    std::size_t wordsPerPlane = 1;
    std::size_t words = 0;

    VoxelLayout() = default;
    explicit VoxelLayout(const GridFrame& grid)
        : frame(grid), wordsPerRow(static_cast<std::size_t>(grid.count[0]) / 64 + 1),
          wordsPerPlane((static_cast<std::size_t>(grid.count[2]) + 1) * wordsPerRow),
          words((static_cast<std::size_t>(grid.count[1]) + 2) * wordsPerPlane)
    {
    }

    [[nodiscard]] std::size_t row(int y, int z) const
    {
        return static_cast<std::size_t>(y + 1) * wordsPerPlane +
               static_cast<std::size_t>(z) * wordsPerRow;
    }

    /// The cube that p lies in; p must be within the frame.
    [[nodiscard]] VoxelWord at(const Eigen::Vector3d& p) const
    {
        const auto c = frame.coordinates(p);
        return at(c[0], c[1], c[2]);
    }
    [[nodiscard]] VoxelWord at(int x, int y, int z) const
    {
        return {row(y, z) + static_cast<std::size_t>(x) / 64, std::uint64_t{1} << (x % 64)};
    }

    /// Coordinates of the cube at bit 0 of a word.
    [[nodiscard]] std::array<int, 3> coordinates(std::size_t word) const
    {
        const std::size_t inPlane = word % wordsPerPlane;
        return {static_cast<int>(inPlane % wordsPerRow) * 64,
                static_cast<int>(word / wordsPerPlane) - 1,
                static_cast<int>(inPlane / wordsPerRow)};
    }

    /// Calls visit(VoxelWord) for the words that hold cubes first..last of row (y, z).
    template <class Visit>
    void forEachWord(int y, int z, int first, int last, Visit&& visit) const
    {
        const std::size_t start = row(y, z);
        for (int w = first / 64; w <= last / 64; ++w)
        {
            std::uint64_t bits = ~std::uint64_t{0};
            if (w == first / 64)
            {
                bits &= ~std::uint64_t{0} << (first % 64);
            }
            if (w == last / 64)
            {
                bits &= ~std::uint64_t{0} >> (63 - last % 64);
            }
            visit(VoxelWord{start + static_cast<std::size_t>(w), bits});
        }
    }

    /// Calls visit(x, y, z) for each cube of a word.
    template <class Visit>
    void forEachCube(VoxelWord cubes, Visit&& visit) const
    {
        const auto c = coordinates(cubes.word);
        for (std::uint64_t bits = cubes.bits; bits != 0; bits &= bits - 1)
        {
            visit(c[0] + std::countr_zero(bits), c[1], c[2]);
        }
    }

    [[nodiscard]] bool any(const VoxelBits& set, int y, int z, int first, int last) const
    {
        if (first / 64 == last / 64) // as nearly always
        {
            const std::size_t word = row(y, z) + static_cast<std::size_t>(first) / 64;
            return (set[word] >> (first % 64) << (63 - last + first)) != 0;
        }
        std::uint64_t found = 0;
        forEachWord(y, z, first, last, [&](VoxelWord w) { found |= set[w.word] & w.bits; });
        return found != 0;
    }
};

} // namespace frostfill
