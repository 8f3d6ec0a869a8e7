// SPDX-License-Identifier: MIT
#include "simulation/motion/vertical_drop.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "simulation/motion/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace frostfill
{
namespace
{

/// Where spheres are looked for that a falling one touches: a column of cells of a level, and how
/// many around it.
struct FallColumn
{
    std::size_t level;
    std::array<int, 3> cell;
    int beside;
};

/// Height at which the first of the spheres is touched that lie in a layer of cells, in p's column
/// or one of those around it.
double contactInLayer(const World& world, const FallColumn& column, int layer,
                      const Eigen::Vector3d& p, double radius)
{
    double highest = -std::numeric_limits<double>::infinity();
    const SphereGrid& resting = world.spheres.resting();
    const std::array<int, 3>& count = resting.frame(column.level).count;
    const auto& [x, y, z] = column.cell;
    const std::array<int, 3> low = {std::max(0, x - column.beside), layer,
                                    std::max(0, z - column.beside)};
    const std::array<int, 3> high = {std::min(count[0] - 1, x + column.beside), layer,
                                     std::min(count[2] - 1, z + column.beside)};
    resting.forEachIn(
        low, high,
        [&](std::uint32_t row)
        {
            const Ball& other = resting[row];
            const double reach = radius + other.radius;
            const double squared = squaredHeightOfTouch(other.position() - p, reach);
            if (squared > 0 && p.y() - other.y > kSlides * reach)
            {
                highest = std::max(highest, std::min(p.y(), other.y + std::sqrt(squared)));
            }
        },
        column.level);
    return highest;
}

/// `highest`: what is touched already.
double sphereOfLevelBelow(const World& world, const FallIndex& falls, const FallColumn& column,
                          const Eigen::Vector3d& p, double radius, double highest)
{
    const SphereGrid& resting = world.spheres.resting();
    const GridFrame& frame = resting.frame(column.level);
    const double reach = radius + resting.largest(column.level);
    const auto next = [&](int from)
    {
        const auto& [x, y, z] = column.cell;
        return falls.highestSphere(x, z, from, column.level, column.beside);
    };
    for (int layer = next(column.cell[1]); layer >= 0;)
    {
        // Whatever lies in this layer is touched lower than at its top and the reach.
        if (column.level > 0 && highest >= frame.origin.y() + frame.cell * (layer + 1) + reach)
        {
            break;
        }
        highest = std::max(highest, contactInLayer(world, column, layer, p, radius));
        // Whatever lies in the layers below is touched lower than this.
        if (layer == 0 || highest >= frame.origin.y() + frame.cell * layer + reach)
        {
            break;
        }
        layer = next(layer - 1);
    }
    return highest;
}

double sphereBelow(const World& world, const FallIndex& falls, const std::array<int, 3>& column,
                   const Eigen::Vector3d& p, double radius)
{
    const SphereGrid& resting = world.spheres.resting();
    double highest = sphereOfLevelBelow(world, falls, {0, column, 1}, p, radius,
                                        -std::numeric_limits<double>::infinity());
    for (std::size_t level = 1; level < resting.levels(); ++level)
    {
        const GridFrame& frame = resting.frame(level);
        const int beside =
            static_cast<int>(std::ceil((radius + resting.largest(level)) / frame.cell));
        highest = sphereOfLevelBelow(world, falls, {level, frame.coordinates(p), beside}, p, radius,
                                     highest);
    }
    return highest;
}

/// How far a sphere can fall from `here`, at most to `end`, in a cell of the triangles' grid.
double fallInCell(const World& world, const std::array<int, 3>& cell, const Eigen::Vector3d& here,
                  double radius, double end)
{
    const Eigen::Vector3d down(0, -1, 0);
    double path = here.y() - end;
    const auto castAt = [&](std::span<const std::uint32_t> triangles)
    {
        for (const std::uint32_t id : triangles)
        {
            if (mayTouch(world.surface.bound(id), here, radius, down, path))
            {
                path = castAtTriangle(world.surface, id, here, radius, down, path);
            }
        }
        return radius;
    };
    const auto ofCell = world.triangles.cell(cell[0], cell[1], cell[2]);
    if (ofCell.size() <= TriangleGrid::kShortList)
    {
        castAt(ofCell);
    }
    else
    {
        const Eigen::Vector3d last(here.x(), end, here.z());
        world.surface.tree().forEachNear(Eigen::AlignedBox3d(last, here), radius, castAt);
    }
    return path;
}

// Goes down cell by cell of the triangles' grid, past layers without a wall at once. Each cell has
// the triangles that can touch a sphere with its centre in it.
double wallBelow(const World& world, const FallIndex& falls, const std::array<int, 3>& column,
                 const Eigen::Vector3d& p, double radius, double lowest)
{
    const GridFrame& fine = world.triangles.frame();
    const GridFrame& coarse = falls.frame();
    const std::array<int, 3> fineColumn = fine.coordinates(p);
    Eigen::Vector3d here = p;
    for (int layer = column[1]; here.y() > lowest; --layer)
    {
        layer = falls.highestWall(column[0], column[2], layer);
        if (layer < 0)
        {
            break;
        }
        const double top = coarse.origin.y() + coarse.cell * (layer + 1);
        const double bottom = std::max(lowest, top - coarse.cell);
        here.y() = std::min(here.y(), top);
        while (here.y() > bottom)
        {
            const int y = fine.coordinate(here.y() - kJustBelow, 1);
            const double end = std::max(bottom, fine.origin.y() + fine.cell * y);
            const double path =
                fallInCell(world, {fineColumn[0], y, fineColumn[2]}, here, radius, end);
            if (path < here.y() - end)
            {
                return here.y() - path;
            }
            here.y() = end;
        }
        if (layer == 0)
        {
            break;
        }
    }
    return lowest;
}

} // namespace

FallIndex::Columns::Columns(const GridFrame& frameOfCells)
    : frame(frameOfCells), words({(frame.count[1] + 63) / 64, frame.count[0], frame.count[2]}),
      bits(words.size())
{
}

void FallIndex::Columns::set(const GridPlace& cell)
{
    const std::size_t word = words.obtain(cell[1] / 64, cell[0], cell[2]);
    if (word >= bits.size())
    {
        bits.resize(words.size());
    }
    bits[word] |= std::uint64_t{1} << (cell[1] % 64);
}

int FallIndex::Columns::highest(int x, int z, int y, int lowest) const
{
    std::uint64_t among = ~std::uint64_t{0} >> (63 - y % 64);
    for (int index = y / 64; index >= lowest / 64; --index, among = ~std::uint64_t{0})
    {
        const std::size_t word = words.find(index, x, z);
        const std::uint64_t set = word == BrickedCells<1>::kNone ? 0 : bits[word] & among;
        if (set != 0)
        {
            return index * 64 + 63 - std::countl_zero(set);
        }
    }
    return -1;
}

FallIndex::FallIndex(const SphereGrid& spheres, const TriangleGrid& triangles)
    : walls_(spheres.frame())
{
    // A cell is a wall when one of the finer cells of the triangles' grid within it has triangles.
    triangles.forEachCellWithTriangles(
        [&](int x, int y, int z)
        { walls_.set(walls_.frame.coordinates(triangles.frame().centre(x, y, z))); });
    for (std::size_t level = 0; level < spheres.levels(); ++level)
    {
        spheres_.emplace_back(spheres.frame(level));
    }
}

int FallIndex::highestSphere(int x, int z, int y, std::size_t level, int beside) const
{
    const Columns& columns = spheres_[level];
    const std::array<int, 3>& count = columns.frame.count;
    int highest = -1;
    for (int nz = std::max(0, z - beside); nz <= std::min(count[2] - 1, z + beside); ++nz)
    {
        for (int nx = std::max(0, x - beside); nx <= std::min(count[0] - 1, x + beside); ++nx)
        {
            // No lower than what is found already.
            highest = std::max(highest, columns.highest(nx, nz, y, std::max(highest, 0)));
        }
    }
    return highest;
}

std::optional<double> contactBelow(const World& world, const FallIndex& falls,
                                   const Eigen::Vector3d& p, double radius)
{
    const auto column = falls.frame().coordinates(p);
    const double sphere = sphereBelow(world, falls, column, p, radius);
    const double y = wallBelow(world, falls, column, p, radius, sphere);
    return std::isfinite(y) ? std::optional(y) : std::nullopt;
}

} // namespace frostfill
