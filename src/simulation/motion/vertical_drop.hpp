// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
#include "simulation/world/world.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// Answers where a falling sphere has to look: a bit for each cell of two radii, set when a wall
/// or the centre of a sphere at rest is in it, stored by columns so that the next one below is
/// found in a few instructions. The smaller spheres of a size curve are in levels, as in
/// SphereGrid.
class FallIndex
{
public:
    /// `spheres`: of its levels; none of its spheres is in the index yet.
    FallIndex(const SphereGrid& spheres, const TriangleGrid& triangles);

    /// `level`: that of the sphere's radius.
    void insert(const Eigen::Vector3d& centre, std::size_t level = 0)
    {
        spheres_[level].set(spheres_[level].frame.coordinates(centre));
    }
    /// Returns the highest layer of cells, at most y, with a sphere's centre in the column (x, z)
    /// or one of those around it that are at most `beside` away; -1 when there is none. In the
    /// first level nothing else than what is beside by one can touch a sphere with its centre in
    /// the column that comes down from layer y.
    [[nodiscard]] int highestSphere(int x, int z, int y, std::size_t level = 0,
                                    int beside = 1) const;
    /// The highest layer, at most y, in which a wall may touch a sphere with its centre in the
    /// column (x, z).
    [[nodiscard]] int highestWall(int x, int z, int y) const { return walls_.highest(x, z, y, 0); }
    /// Of walls, and of the first level of spheres.
    [[nodiscard]] const GridFrame& frame() const { return walls_.frame; }

private:
    /// A bit for each cell of a grid.
    struct Columns
    {
        explicit Columns(const GridFrame& frameOfCells);

        void set(const GridPlace& cell);
        /// The highest set bit of a column in layers y and below, down to the word with `lowest`.
        [[nodiscard]] int highest(int x, int z, int y, int lowest) const;

        GridFrame frame;
        BrickedCells<1> words;           ///< of 64 cells each, by their layer, x and z
        std::vector<std::uint64_t> bits; ///< [#words]
    };

    Columns walls_;
    std::vector<Columns> spheres_; ///< by level
};

/// Height at which a sphere of `radius` (at most 1) that falls straight down from p, where it is
/// clear of everything, first touches something at rest. Exact for spheres; walls to 1e-10 r. None
/// where nothing is below p, which is then outside the object.
[[nodiscard]] std::optional<double> contactBelow(const World& world, const FallIndex& falls,
                                                 const Eigen::Vector3d& p, double radius);

} // namespace frostfill
