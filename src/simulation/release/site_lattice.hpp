// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "geometry/bricked_cells.hpp"
#include "mesh/interior/inside_test.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/release/word_spans.hpp"
#include "simulation/world/spheres.hpp"

#include <algorithm>
#include <cstdint>
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
/// Words of 64 cells lie along x. A small lattice has all words of its box, a large one a list of
/// those that were open once. Sites are numbered along both, ascending in z, y, x, with gaps.
class SiteLattice
{
public:
    /// `radius` is at most 1. `coarsest`: cells are as large as those for this radius, if it is
    /// larger; there may be places in them that no site leads to.
    SiteLattice(const Surface& surface, const InsideTest& inside, double radius, Threads& threads,
                double smallLattice = kSmallLattice, double coarsest = 0);

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
    /// The next open site from `site` on, or end(). Ascending in z, y, x.
    [[nodiscard]] std::size_t nextOpen(std::size_t site) const;

    /// The open sites whose neighbour above is not open, ascending.
    [[nodiscard]] std::vector<std::uint32_t> highest() const;

    [[nodiscard]] double cell() const { return lattice_.cell; }
    [[nodiscard]] double halfDiagonal() const { return 0.8660254037844387 * lattice_.cell; }

private:
    class Sides;
    static constexpr std::size_t kNone = WordSpans::kNone;

    void listWords(const Eigen::AlignedBox3d& box, const InsideTest& inside);
    void dropClosedWords();
    /// Closes all within a distance of the surface.
    void closeNear(const Surface& surface, double distance, Threads& threads);
    /// Then all that are outside, but for those near the surface, which may be opened.
    void closeOutside(const InsideTest& inside, double distance, bool nearAreOpen,
                      Threads& threads);
    void closeRun(int y, int z, int first, int last);
    [[nodiscard]] WordPlace place(std::size_t word) const
    {
        if (list_.size() > 0)
        {
            return list_.place(word);
        }
        const std::size_t row = word / wordsPerRow_;
        const auto rows = static_cast<std::size_t>(lattice_.count[1]);
        return {static_cast<int>(word % wordsPerRow_), static_cast<int>(row % rows),
                static_cast<int>(row / rows)};
    }
    /// Number of the first word from this one on.
    [[nodiscard]] std::size_t firstFrom(const WordPlace& word) const
    {
        if (list_.size() == 0)
        {
            const auto rows = static_cast<std::size_t>(lattice_.count[1]);
            return (static_cast<std::size_t>(word[2]) * rows + static_cast<std::size_t>(word[1])) *
                       wordsPerRow_ +
                   static_cast<std::size_t>(word[0]);
        }
        return list_.firstFrom(word);
    }
    /// Number of a word, or kNone.
    [[nodiscard]] std::size_t find(const WordPlace& word) const
    {
        return list_.size() == 0 ? firstFrom(word) : list_.find(word);
    }

    double radius_;
    GridFrame lattice_;
    std::size_t wordsPerRow_;
    WordSpans list_;                  ///< the words of a large lattice
    std::vector<std::uint64_t> bits_; ///< [#words]
};

} // namespace frostfill
