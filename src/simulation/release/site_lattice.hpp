// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "mesh/interior/inside_test.hpp"
#include "simulation/world/spheres.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// A lattice of half a radius over the object, a bit a cell: whether the cell may still hold the
/// centre of a sphere of that radius. Spheres at rest close the cells that lie wholly within the
/// two radii; a cell that is closed stays closed.
class SiteLattice
{
public:
    /// `radius` is at most 1.
    SiteLattice(const Surface& surface, const InsideTest& inside, double radius, Threads& threads);

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
    /// The next open site from `site` on, or lattice().size(). Ascending in z, y, x.
    [[nodiscard]] std::size_t nextOpen(std::size_t site) const;

    /// The open sites whose neighbour above is not open, ascending.
    [[nodiscard]] std::vector<std::uint32_t> highest() const;

    [[nodiscard]] double cell() const { return lattice_.cell; }
    [[nodiscard]] double halfDiagonal() const { return 0.8660254037844387 * lattice_.cell; }

private:
    void openLayer(const InsideTest& inside, int z);
    /// The last site of a row, from site x on, that lies before a coordinate; x if none does.
    [[nodiscard]] int lastBefore(double end, int x) const;
    void closeRun(std::size_t first, std::size_t last);
    /// 64 sites from this one on, the first in the lowest bit.
    [[nodiscard]] std::uint64_t openFrom(std::size_t site) const;

    double radius_;
    GridFrame lattice_;
    std::vector<std::uint64_t> bits_;
};

} // namespace frostfill
