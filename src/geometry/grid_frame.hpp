// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace frostfill
{

/// From the middle of a unit cube to a corner.
inline constexpr double kHalfDiagonal = 0.8660254037844387;
/// Along an axis: what fits an int, with room to count a few beyond the end.
inline constexpr double kMostCellsAlong = 2e9;

/// Whole numbers low..high that lie in [from, to] and are the number of a cell, of so many, without
/// calls.
inline std::array<int, 2> wholeNumbers(double from, double to, int count)
{
    from = std::max(from, 0.0);
    to = std::min(to, count - 1.0);
    if (!(from <= to))
    {
        return {0, -1};
    }
    const int low = static_cast<int>(from);
    return {low < from ? low + 1 : low, static_cast<int>(to)};
}

/// A box divided into equal cubes. Of more than an int counts along an axis the rest is missing.
/// Cells are numbered with x fastest. A point outside the box belongs to the nearest border cell,
/// so a lookup never leaves the array.
struct GridFrame
{
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< lower corner
    double cell = 1;                                  ///< edge of a cube
    std::array<int, 3> count = {1, 1, 1};             ///< cells along each axis

    static GridFrame cover(const Eigen::AlignedBox3d& box, double cell, double margin)
    {
        GridFrame frame;
        frame.cell = cell;
        frame.origin = box.min().array() - margin;
        for (int axis = 0; axis < 3; ++axis)
        {
            const double length = box.sizes()[axis] + 2 * margin;
            const double cells = std::max(1.0, std::ceil(length / cell));
            frame.count[axis] = static_cast<int>(std::min(cells, kMostCellsAlong));
        }
        return frame;
    }

    [[nodiscard]] int coordinate(double position, int axis) const
    {
        // Clamped first, so truncation rounds down.
        const double index = (position - origin[axis]) / cell;
        const double last = count[axis] - 1;
        return static_cast<int>(index > 0 ? (index < last ? index : last) : 0.0);
    }
    [[nodiscard]] std::array<int, 3> coordinates(const Eigen::Vector3d& p) const
    {
        return {coordinate(p.x(), 0), coordinate(p.y(), 1), coordinate(p.z(), 2)};
    }
    [[nodiscard]] std::size_t index(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * count[1] + y) * count[0] + x;
    }
    [[nodiscard]] std::size_t index(const Eigen::Vector3d& p) const
    {
        const auto c = coordinates(p);
        return index(c[0], c[1], c[2]);
    }
    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const
    {
        const Eigen::Vector3d upper = origin + cell * Eigen::Vector3d(count[0], count[1], count[2]);
        return (p.array() >= origin.array()).all() && (p.array() < upper.array()).all();
    }
    [[nodiscard]] std::size_t size() const
    {
        return static_cast<std::size_t>(count[0]) * count[1] * count[2];
    }
    /// First and last of the cells along an axis whose centre lies in [from, to].
    [[nodiscard]] std::array<int, 2> centresWithin(int axis, double from, double to) const
    {
        const double first = origin[axis] + cell * 0.5;
        return wholeNumbers((from - first) / cell, (to - first) / cell,
                            count[static_cast<std::size_t>(axis)]);
    }
    [[nodiscard]] Eigen::Vector3d centre(int x, int y, int z) const
    {
        return origin + cell * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
    }
};

// Cells of a grid, row by row along x.

/// Widens a filter before the exact test: what a row is asked for. [cells] Smaller: rounding hides
/// a cell. Larger: cells are tested in vain.
inline constexpr double kFilterRounding = 1e-6;

/// Cells first..last of a row; none when last < first.
struct CellRun
{
    int first;
    int last;
};

/// Calls visit(word, bits) for the words of a row, 64 cells each, that have cells of a run: bit i
/// of word w is cell 64 w + i.
template <class Visit>
void forEachWordOf(CellRun run, Visit&& visit)
{
    for (int word = run.first / 64; run.first <= run.last && word <= run.last / 64; ++word)
    {
        std::uint64_t bits = ~std::uint64_t{0};
        bits &= word == run.first / 64 ? ~std::uint64_t{0} << run.first % 64 : bits;
        bits &= word == run.last / 64 ? ~std::uint64_t{0} >> (63 - run.last % 64) : bits;
        visit(word, bits);
    }
}

} // namespace frostfill
