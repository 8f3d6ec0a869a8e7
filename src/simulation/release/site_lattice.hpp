// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "geometry/bricked_cells.hpp"
#include "mesh/interior/inside_test.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/spheres.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Edge of the cells of a lattice for spheres of a radius [r]. They grow until there are few enough
/// along each axis and in all: in the box, or, where that is large, in `inReach` of it [r^3].
[[nodiscard]] double cellOfSites(const Eigen::Vector3d& box, double inReach, double radius);

/// A lattice of half a radius over the object, a bit a cell: whether the cell may still hold the
/// centre of a sphere of that radius. Spheres at rest close the cells that lie wholly within the
/// two radii; a cell that is closed stays closed.
///
/// Words of 64 cells lie along x. A small lattice has all words of its box, a large one those of
/// the bricks that the object reaches. Sites are numbered by words, with gaps.
class SiteLattice
{
public:
    /// `radius` is at most 1. `coarsest`: cells are as large as those for this radius, if it is
    /// larger; there may be places in them that no site leads to.
    SiteLattice(const Surface& surface, const InsideTest& inside, double radius, Threads& threads,
                double coarsest = 0, std::size_t smallLattice = kSmallLattice);

    /// Closes all cells that a sphere at rest leaves no place in.
    void close(const Eigen::Vector3d& centre, double radius);
    void closeSite(std::size_t site) { bits_[site / 64] &= ~(std::uint64_t{1} << (site % 64)); }

    /// A sphere at rest of this radius closes the sites whose centre is nearer than this.
    [[nodiscard]] double closedWithin(double radius) const
    {
        return radius + radius_ - halfDiagonal(); // all their points are within the two radii
    }

    [[nodiscard]] bool isOpen(std::size_t site) const
    {
        return (bits_[site / 64] >> (site % 64) & 1u) != 0;
    }
    [[nodiscard]] const GridFrame& lattice() const { return lattice_; }
    [[nodiscard]] Eigen::Vector3d centre(std::size_t site) const;
    /// Layer of a site along y, from below.
    [[nodiscard]] int height(std::size_t site) const { return place(site / 64)[1]; }
    /// Above the number of every site.
    [[nodiscard]] std::size_t end() const { return 64 * bits_.size(); }
    /// The next open site from `site` on, or end().
    [[nodiscard]] std::size_t nextOpen(std::size_t site) const;

    /// The open sites whose neighbour above is not open, ascending.
    [[nodiscard]] std::vector<std::uint32_t> highest() const;

    [[nodiscard]] double cell() const { return lattice_.cell; }
    [[nodiscard]] double halfDiagonal() const { return kHalfDiagonal * lattice_.cell; }
    /// Sites are opened where their centre is so deep inside the object [r]; negative: so little
    /// outside.
    [[nodiscard]] double depth() const { return depth_; }

private:
    using Words = BrickedCells<1>;
    static constexpr std::size_t kNone = Words::kNone;

    void obtainWords(const Eigen::AlignedBox3d& box, const InsideTest& inside);
    void markNear(const Surface& surface, double distance, Threads& threads);
    void openInside(const InsideTest& inside, Threads& threads);
    [[nodiscard]] std::uint64_t openOfWord(std::size_t word, std::span<const std::uint64_t> near,
                                           std::size_t first, const InsideTest& inside) const;
    void closeRun(int y, int z, int first, int last);
    /// Where a word lies: its place in its row, and the row.
    [[nodiscard]] GridPlace place(std::size_t word) const
    {
        if (!words_.isOne())
        {
            return words_.cell(word);
        }
        const std::size_t row = word / wordsInRow();
        const auto rows = static_cast<std::size_t>(lattice_.count[1]);
        return {static_cast<int>(word % wordsInRow()), static_cast<int>(row % rows),
                static_cast<int>(row / rows)};
    }
    [[nodiscard]] std::size_t wordsInRow() const
    {
        return (static_cast<std::size_t>(lattice_.count[0]) + 63) / 64;
    }
    [[nodiscard]] GridPlace countOfWords() const
    {
        return {static_cast<int>(wordsInRow()), lattice_.count[1], lattice_.count[2]};
    }

    double radius_;
    GridFrame lattice_;
    Words words_;
    double depth_ = 0;
    std::vector<std::uint64_t> bits_; ///< [#words_]
};

} // namespace frostfill
