// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "base/threads.hpp"
#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/inside_test.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace frostfill
{

/// A set of cubes of a grid, one bit each, in the words of a Cubes.
using CubeSet = std::vector<std::uint64_t>;

/// Some cubes of one row: bit i of word `word`.
struct CubeWord
{
    std::size_t word;
    std::uint64_t bits;
};

inline bool has(const CubeSet& set, CubeWord cube)
{
    return (set[cube.word] & cube.bits) != 0;
}

/// Numbers the cubes of a grid, of a large one those that may hold a point inside of a surface or
/// within its reach: 64 cubes along x make a word, and in a large grid 4 x 4 words a brick. All
/// other cubes share the first words, which no set has. Memory therefore follows the inside, not
/// the box around it.
class Cubes
{
public:
    /// Words that are no cubes.
    static constexpr std::size_t kNowhere = BrickedCells<1>::kInBrick;

    /// Words up to which a grid has those of its whole box. [1] Larger: memory for cubes outside.
    /// Smaller: searches in ordinary objects look up bricks.
    static constexpr std::size_t kWhole = std::size_t{1} << 22;

    Cubes() : words_({1, 1, 1}, 0) {}
    /// Of a grid of at most `whole` words all cubes. Nothing when there are more words than `most`.
    [[nodiscard]] static std::optional<Cubes> inReach(const GridFrame& frame,
                                                      const InsideTest& inside, double most,
                                                      std::size_t whole = kWhole);

    [[nodiscard]] const GridFrame& frame() const { return frame_; }
    [[nodiscard]] std::size_t words() const { return kNowhere + words_.size(); }
    /// Word x of row (y, z), which lie in the grid.
    [[nodiscard]] std::size_t word(int x, int y, int z) const
    {
        return kNowhere + words_.find(x, y, z); // without a brick: the last word of brick 0
    }
    /// The same of any row.
    [[nodiscard]] std::size_t wordIfAny(int x, int y, int z) const
    {
        return words_.isInGrid({x, y, z}) ? word(x, y, z) : 0;
    }
    [[nodiscard]] CubeWord at(const GridPlace& cube) const
    {
        return {word(cube[0] / 64, cube[1], cube[2]), std::uint64_t{1} << (cube[0] % 64)};
    }
    [[nodiscard]] CubeWord at(const Eigen::Vector3d& p) const { return at(frame_.coordinates(p)); }
    /// The cube at bit 0 of a word.
    [[nodiscard]] GridPlace first(std::size_t word) const
    {
        const GridPlace place = words_.cell(word - kNowhere);
        return {place[0] * 64, place[1], place[2]};
    }
    /// Returns all cubes.
    [[nodiscard]] CubeSet all() const;
    /// The cubes of a word that lie in the grid.
    [[nodiscard]] std::uint64_t inGrid(std::size_t word) const;
    [[nodiscard]] Eigen::Vector3d middle(const GridPlace& cube) const
    {
        return frame_.centre(cube[0], cube[1], cube[2]);
    }

    /// Calls visit(place) for each cube of a word.
    template <class Visit>
    void forEachCube(CubeWord cubes, Visit&& visit) const
    {
        const GridPlace start = first(cubes.word);
        for (std::uint64_t bits = cubes.bits; bits != 0; bits &= bits - 1)
        {
            visit(GridPlace{start[0] + std::countr_zero(bits), start[1], start[2]});
        }
    }
    /// The bits of a run that begins and ends in one word.
    [[nodiscard]] static std::uint64_t bitsOf(CellRun run)
    {
        return ~std::uint64_t{0} >> (63 - (run.last - run.first)) << (run.first & 63);
    }
    /// Takes cubes first..last of row (y, z) out of a set.
    void takeOut(CubeSet& set, int y, int z, CellRun run) const
    {
        if (run.first >> 6 == run.last >> 6) // as nearly always
        {
            set[word(run.first >> 6, y, z)] &= ~bitsOf(run);
            return;
        }
        forEachWordOf(run, [&](int x, std::uint64_t bits) { set[word(x, y, z)] &= ~bits; });
    }
    /// Whether some cubes from `low` to `high`, both included, are in a set.
    [[nodiscard]] bool any(const CubeSet& set, const GridPlace& low, const GridPlace& high) const
    {
        std::uint64_t found = 0;
        forEachWordOf({low[0], high[0]},
                      [&](int x, std::uint64_t bits)
                      {
                          for (int z = low[2]; z <= high[2]; ++z)
                          {
                              for (int y = low[1]; y <= high[1]; ++y)
                              {
                                  found |= set[word(x, y, z)] & bits;
                              }
                          }
                      });
        return found != 0;
    }
    /// Calls visit(CubeWord) for the cubes of other words that share a face with `cubes`.
    template <class Visit>
    void forEachNeighbour(CubeWord cubes, Visit&& visit) const
    {
        const GridPlace at = words_.cell(cubes.word - kNowhere);
        const auto [x, y, z] = at;
        visit(CubeWord{wordIfAny(x, y - 1, z), cubes.bits});
        visit(CubeWord{wordIfAny(x, y + 1, z), cubes.bits});
        visit(CubeWord{wordIfAny(x, y, z - 1), cubes.bits});
        visit(CubeWord{wordIfAny(x, y, z + 1), cubes.bits});
        visit(CubeWord{wordIfAny(x - 1, y, z), cubes.bits << 63});
        visit(CubeWord{wordIfAny(x + 1, y, z), cubes.bits >> 63});
    }
    /// Takes the cubes out of a set that are connected through faces with some of it. Calls
    /// visit(CubeWord) for them, a part of a row at a time.
    template <class Visit>
    void takeConnected(CubeSet& set, CubeWord start, Visit&& visit) const
    {
        // In breadth, whose border is a surface: in depth most of the set would wait at once.
        std::vector<CubeWord> border = {start};
        std::vector<CubeWord> beyond;
        for (; !border.empty(); std::swap(border, beyond), beyond.clear())
        {
            for (const auto& [word, bits] : border)
            {
                const CubeWord found{word, filled(bits, set[word])};
                if (found.bits == 0)
                {
                    continue;
                }
                set[word] &= ~found.bits;
                visit(found);
                forEachNeighbour(found,
                                 [&](CubeWord next)
                                 {
                                     if ((set[next.word] & next.bits) != 0)
                                     {
                                         beyond.push_back(next);
                                     }
                                 });
            }
        }
    }

private:
    /// The cubes of a row's word that are connected with `start` inside `open`: the occluded fill
    /// of chess programs, six doublings to each side [Kogge & Stone 1973].
    [[nodiscard]] static std::uint64_t filled(std::uint64_t start, std::uint64_t open)
    {
        std::uint64_t up = start & open;
        std::uint64_t down = up;
        std::uint64_t upOpen = open;
        std::uint64_t downOpen = open;
        for (int shift = 1; shift < 64; shift *= 2)
        {
            up |= upOpen & (up << shift);
            upOpen &= upOpen << shift;
            down |= downOpen & (down >> shift);
            downOpen &= downOpen >> shift;
        }
        return up | down;
    }

    GridFrame frame_;
    BrickedCells<1> words_;
};

/// Returns those of a set whose middle is farther than this from the surface.
[[nodiscard]] CubeSet cubesFartherThan(const Surface& surface, const Cubes& cubes, double distance,
                                       CubeSet among, Threads& threads);

/// Returns those of a set that are inside of the surface. Cubes that are connected through faces
/// have to lie on one side.
[[nodiscard]] CubeSet cubesInside(const Cubes& cubes, const InsideTest& inside, CubeSet among);

/// Which cubes belong to a ball, by what is added to the distance of their middle along each axis.
inline constexpr double kInsideBall = 0.5; ///< [edge] the farthest corner is within the radius
inline constexpr double kMiddleInBall = 0; ///< [edge] the middle is
inline constexpr double kMeetsBall = -0.5; ///< [edge] the nearest point is

/// Calls test(y, z, run) for the rows of a grid with cubes of a ball, from the top down, until it
/// returns true. Returns whether it did.
template <class Test>
bool findRowOfBall(const GridFrame& frame, const Eigen::Vector3d& centre, double radius,
                   double half, Test&& test)
{
    const Eigen::Vector3d c = ((centre - frame.origin) / frame.cell).array() - 0.5;
    const double r = radius / frame.cell;
    const auto rangeOf = [&](int axis, double reach)
    { return wholeNumbers(c[axis] - reach, c[axis] + reach, frame.count[axis]); };
    const auto squareOf = [&](int axis, int place)
    {
        const double apart = std::max(0.0, std::abs(place - c[axis]) + half);
        return apart * apart;
    };
    const auto [lowY, highY] = rangeOf(1, r - half);
    const auto [lowZ, highZ] = rangeOf(2, r - half);
    for (int y = highY; y >= lowY; --y)
    {
        const double leftOfY = r * r - squareOf(1, y);
        for (int z = lowZ; z <= highZ; ++z)
        {
            const double left = leftOfY - squareOf(2, z);
            if (left < 0)
            {
                continue;
            }
            const auto [first, last] = rangeOf(0, std::sqrt(left) - half);
            if (first <= last && test(y, z, CellRun{first, last}))
            {
                return true;
            }
        }
    }
    return false;
}

/// Calls body(k) for each k below `count`, which is about the sphere in row rowOf(k) of a grid.
/// Spheres of one slab along z come one after another, and slabs as in forEachSlab: a body may
/// change a set of cubes within some radii of its sphere, whatever the number of threads.
template <class RowOf, class Body>
void forEachBySlab(const SphereGrid& grid, std::size_t count, Threads& threads, RowOf&& rowOf,
                   Body&& body)
{
    constexpr int kThickness = 8; // layers of cells, which are worth a thread's while
    const int slabs = (grid.frame().count[2] + kThickness - 1) / kThickness;
    const Buckets<std::uint32_t> bySlab(
        static_cast<std::size_t>(slabs),
        [&](auto&& enter)
        {
            for (std::uint32_t k = 0; k < count; ++k)
            {
                const int slab = grid.frame().coordinate(grid[rowOf(k)].z, 2) / kThickness;
                enter(static_cast<std::size_t>(slab), k);
            }
        });
    forEachSlab(threads, slabs,
                [&](int slab)
                {
                    for (const std::uint32_t k : bySlab[static_cast<std::size_t>(slab)])
                    {
                        body(k);
                    }
                });
}

} // namespace frostfill
