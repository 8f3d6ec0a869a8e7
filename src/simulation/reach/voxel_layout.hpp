// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/cell_rows.hpp"
#include "geometry/grid_frame.hpp"
#include "simulation/reach/voxel_bricks.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace frostfill
{

/// A set of cubes of a grid, one bit each, in the order of a VoxelLayout.
using VoxelBits = std::vector<std::uint64_t>;

[[nodiscard]] inline std::size_t countCubes(const VoxelBits& set)
{
    std::size_t count = 0;
    for (const std::uint64_t word : set)
    {
        count += static_cast<std::size_t>(std::popcount(word));
    }
    return count;
}

/// Some cubes of one row: bit i of word `word`.
struct VoxelWord
{
    std::size_t word;
    std::uint64_t bits;
};

/// A cube by its number among all that have a bit.
using CubeNumber = std::uint64_t;
inline constexpr CubeNumber kNoCube = ~CubeNumber{0};
[[nodiscard]] inline CubeNumber numberOf(VoxelWord cube)
{
    return 64 * CubeNumber{cube.word} + static_cast<CubeNumber>(std::countr_zero(cube.bits));
}
[[nodiscard]] inline VoxelWord cubeOf(CubeNumber number)
{
    return {number / 64, std::uint64_t{1} << number % 64};
}

/// How the cubes of a grid are packed into words: rows run along x, planes lie level.
///
/// The whole of a grid: every row ends in a bit that is never set, every plane in a row and the
/// whole in planes that are never set, so that the neighbours of any word are found by adding to
/// its number and nothing is compared with the border.
///
/// Or its bricks, which hold all that is inside of a surface, so that memory follows the inside and
/// not the box around it. See VoxelBricks.
struct VoxelLayout
{
    GridFrame frame;
    std::size_t words = 0;

    VoxelLayout() = default;
    explicit VoxelLayout(const GridFrame& grid)
        : frame(grid), words((static_cast<std::size_t>(grid.count[1]) + 2) *
                             (static_cast<std::size_t>(grid.count[2]) + 1) *
                             (static_cast<std::size_t>(grid.count[0]) / 64 + 1)),
          wordsPerRow_(static_cast<std::size_t>(grid.count[0]) / 64 + 1),
          wordsPerPlane_((static_cast<std::size_t>(grid.count[2]) + 1) * wordsPerRow_)
    {
    }
    VoxelLayout(const GridFrame& grid, std::shared_ptr<const VoxelBricks> bricks)
        : frame(grid), words(bricks->words()), bricks_(std::move(bricks))
    {
    }

    [[nodiscard]] bool isWhole() const { return bricks_ == nullptr; }

    /// The cube that p lies in; p must be within the frame.
    [[nodiscard]] VoxelWord at(const Eigen::Vector3d& p) const
    {
        const auto c = frame.coordinates(p);
        return at(c[0], c[1], c[2]);
    }
    [[nodiscard]] VoxelWord at(int x, int y, int z) const
    {
        return {word(x / 64, y, z), std::uint64_t{1} << (x % 64)};
    }
    /// Word x of row (y, z). What has none shares an empty one.
    [[nodiscard]] std::size_t word(int x, int y, int z) const
    {
        return isWhole()
                   ? static_cast<std::size_t>(y + 1) * wordsPerPlane_ +
                         static_cast<std::size_t>(z) * wordsPerRow_ + static_cast<std::size_t>(x)
                   : bricks_->find(x, y, z);
    }
    /// Whether the word is that of cubes that have none.
    [[nodiscard]] bool isNowhere(std::size_t word) const
    {
        return !isWhole() && VoxelBricks::isNowhere(word);
    }

    /// Coordinates of the cube at bit 0 of a word that has cubes.
    [[nodiscard]] std::array<int, 3> coordinates(std::size_t word) const
    {
        if (!isWhole())
        {
            const GridPlace place = bricks_->place(word);
            return {place[0] * 64, place[1], place[2]};
        }
        const std::size_t inPlane = word % wordsPerPlane_;
        return {static_cast<int>(inPlane % wordsPerRow_) * 64,
                static_cast<int>(word / wordsPerPlane_) - 1,
                static_cast<int>(inPlane / wordsPerRow_)};
    }
    [[nodiscard]] WordsBeside beside(std::size_t word) const
    {
        return isWhole() ? WordsBeside{word - 1,
                                       word + 1,
                                       word - wordsPerPlane_,
                                       word + wordsPerPlane_,
                                       word - wordsPerRow_,
                                       word + wordsPerRow_}
                         : bricks_->beside(word);
    }

    /// Calls visit(VoxelWord) for the words that hold cubes first..last of row (y, z).
    template <class Visit>
    void forEachWord(int y, int z, int first, int last, Visit&& visit) const
    {
        forEachWordOf({first, last},
                      [&](int w, std::uint64_t bits) {
                          visit(VoxelWord{word(w, y, z), bits});
                      });
    }
    /// Looks among the cubes of a set that are in first..last of row (y, z), ascending, for one for
    /// which test(x, VoxelWord) holds; it may take it out of the set.
    template <class Test>
    bool findInRow(const VoxelBits& set, int y, int z, int first, int last, Test&& test) const
    {
        for (int w = first / 64; first <= last; first = 64 * ++w)
        {
            const std::size_t its = word(w, y, z);
            const int end = std::min(last, 64 * w + 63);
            std::uint64_t bits = set[its] & (~std::uint64_t{0} << (first % 64)) &
                                 (~std::uint64_t{0} >> (63 - end % 64));
            for (; bits != 0; bits &= bits - 1)
            {
                const int bit = std::countr_zero(bits);
                if (test(64 * w + bit, VoxelWord{its, std::uint64_t{1} << bit}))
                {
                    return true;
                }
            }
        }
        return false;
    }
    /// The cubes of a word that are in the grid.
    [[nodiscard]] std::uint64_t inGrid(std::size_t word) const;
    /// Calls visit(VoxelWord) for all words, with their cubes that are in the grid.
    template <class Visit>
    void forEachWord(Visit&& visit) const
    {
        const auto& count = frame.count;
        for (int y = 0; isWhole() && y < count[1]; ++y)
        {
            for (int z = 0; z < count[2]; ++z)
            {
                forEachWord(y, z, 0, count[0] - 1, visit);
            }
        }
        for (std::size_t word = isWhole() ? words : 0; word < words; ++word)
        {
            if (const std::uint64_t bits = inGrid(word); bits != 0)
            {
                visit(VoxelWord{word, bits});
            }
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
            return (set[word(first / 64, y, z)] >> (first % 64) << (63 - last + first)) != 0;
        }
        std::uint64_t found = 0;
        forEachWord(y, z, first, last, [&](VoxelWord w) { found |= set[w.word] & w.bits; });
        return found != 0;
    }

    /// The first of the rows (y, z) to (y, lastZ) that has some of its cubes first..last in a set;
    /// lastZ + 1 if there is none.
    [[nodiscard]] int firstRow(const VoxelBits& set, int y, int z, int lastZ, int first,
                               int last) const
    {
        if (!isWhole() || first / 64 != last / 64)
        {
            while (z <= lastZ && !any(set, y, z, first, last))
            {
                ++z;
            }
            return z;
        }
        const std::uint64_t its = ~std::uint64_t{0} << (63 - last + first) >> (63 - last % 64);
        for (std::size_t at = word(first / 64, y, z); z <= lastZ && (set[at] & its) == 0; ++z)
        {
            at += wordsPerRow_;
        }
        return z;
    }

    /// Calls visit(VoxelWord) for cubes beside what has no word, which is all outside and beyond
    /// reach of the surface; of a whole grid for one cube at its border.
    template <class Visit>
    void forEachOutermost(Visit&& visit) const
    {
        if (isWhole())
        {
            visit(at(0, 0, 0));
            return;
        }
        for (std::size_t word = 0; word < words; ++word)
        {
            if (const std::uint64_t bits = besideNothing(word); bits != 0)
            {
                visit(VoxelWord{word, bits});
            }
        }
    }

private:
    /// Those of them with a neighbour that is in no brick, or not in the grid.
    [[nodiscard]] std::uint64_t besideNothing(std::size_t word) const;

    std::size_t wordsPerRow_ = 1; ///< of a whole grid
    std::size_t wordsPerPlane_ = 1;
    std::shared_ptr<const VoxelBricks> bricks_; ///< none of a whole grid
};

} // namespace frostfill
