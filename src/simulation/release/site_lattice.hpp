// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/cubes.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Edge of the cells of a lattice for spheres of a radius [r], or a larger one so that there are
/// few enough along each axis and in `inReach` of the box [r^3].
[[nodiscard]] double cellOfSites(const Eigen::Vector3d& box, double inReach, double radius);

/// A lattice of half a radius over the object, a bit a cell: whether the cell may still hold the
/// centre of a sphere of that radius. Spheres at rest close the cells that lie wholly within the
/// two radii; a cell that is closed stays closed. Sites are numbered by the words of Cubes, with
/// gaps.
class SiteLattice
{
public:
    /// `radius` is at most 1. `coarsest`: cells are as large as those for this radius, if it is
    /// larger; there may be places in them that no site leads to.
    SiteLattice(const Surface& surface, const InsideTest& inside, double radius, Threads& threads,
                double coarsest = 0, std::size_t whole = Cubes::kWhole);

    /// Closes all cells that a sphere at rest leaves no place in.
    void close(const Eigen::Vector3d& centre, double radius);
    void closeSite(std::size_t site) { open_[site / 64] &= ~(std::uint64_t{1} << (site % 64)); }
    /// A sphere at rest of this radius closes the sites whose centre is nearer than this.
    [[nodiscard]] double closedWithin(double radius) const
    {
        return radius + radius_ - halfDiagonal(); // all their points are within the two radii
    }

    [[nodiscard]] bool isOpen(std::size_t site) const
    {
        return (open_[site / 64] >> (site % 64) & 1u) != 0;
    }
    [[nodiscard]] const GridFrame& lattice() const { return cubes_.frame(); }
    [[nodiscard]] Eigen::Vector3d centre(std::size_t site) const
    {
        const auto [x, y, z] = cubes_.first(site / 64);
        return lattice().centre(x + static_cast<int>(site % 64), y, z);
    }
    /// Layer of a site along y, from below.
    [[nodiscard]] int height(std::size_t site) const { return cubes_.first(site / 64)[1]; }
    /// The lowest number that a site may have, and one above the number of every site.
    [[nodiscard]] static constexpr std::size_t begin() { return 64 * Cubes::kNowhere; }
    [[nodiscard]] std::size_t end() const { return 64 * open_.size(); }
    /// The next open site from `site` on, or end().
    [[nodiscard]] std::size_t nextOpen(std::size_t site) const;
    /// The open sites whose neighbour above is not open, ascending.
    [[nodiscard]] std::vector<std::uint32_t> highest() const;
    [[nodiscard]] double cell() const { return lattice().cell; }
    [[nodiscard]] double halfDiagonal() const { return kHalfDiagonal * cell(); }
    /// Sites are opened where their centre is so deep inside the object [r]; negative: so little
    /// outside.
    [[nodiscard]] double depth() const { return depth_; }

private:
    double radius_;
    Cubes cubes_;
    double depth_ = 0;
    CubeSet open_;
};

} // namespace frostfill
