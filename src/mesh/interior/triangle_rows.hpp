// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/cell_rows.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/surface.hpp"
#include "mesh/interior/triangle_groups.hpp"

namespace frostfill
{

/// Words of 64 cells in the box of a triangle from which on it is cut into rows. Larger: rows of a
/// long triangle's box that it is nowhere near. Smaller: cuts that find hardly less.
inline constexpr std::uint64_t kLargeWindow = 4096;

/// A triangle, or what is left of it between planes that are square to the axes.
class TrianglePart
{
public:
    explicit TrianglePart(const SurfaceTriangle& triangle)
    {
        std::copy(triangle.corner.begin(), triangle.corner.end(), corner_.begin());
    }

    /// What is left between two planes square to an axis.
    [[nodiscard]] TrianglePart between(int axis, double low, double high) const
    {
        return beyond(axis, low, 1).beyond(axis, high, -1);
    }
    /// From where to where it goes along an axis; from infinity to -infinity when nothing is left.
    [[nodiscard]] std::array<double, 2> extent(int axis) const
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::array<double, 2> result = {kInfinity, -kInfinity};
        for (std::size_t k = 0; k < count_; ++k)
        {
            result = {std::min(result[0], corner_[k][axis]), std::max(result[1], corner_[k][axis])};
        }
        return result;
    }

private:
    TrianglePart() = default;

    // One plane adds a corner at most. [Sutherland & Hodgman 1974]
    [[nodiscard]] TrianglePart beyond(int axis, double bound, double side) const
    {
        TrianglePart part;
        part.count_ = 0;
        for (std::size_t k = 0; k < count_; ++k)
        {
            const Eigen::Vector3d& here = corner_[k];
            const Eigen::Vector3d& next = corner_[(k + 1) % count_];
            const double a = side * (here[axis] - bound);
            const double b = side * (next[axis] - bound);
            if (a >= 0)
            {
                part.corner_[part.count_++] = here;
            }
            if ((a < 0) != (b < 0))
            {
                part.corner_[part.count_++] = here + a / (a - b) * (next - here);
            }
        }
        return part;
    }

    std::size_t count_ = 3;
    std::array<Eigen::Vector3d, 7> corner_; ///< of three, and one for each of four planes
};

/// The cells of a grid whose middle is within `reach` of a triangle.
class TriangleRows
{
public:
    TriangleRows(const GridFrame& frame, const Surface& surface, std::uint32_t id, double reach)
        : frame_(frame), triangle_(surface[id]), plane_(surface.bound(id)), reach_(reach),
          near_(surface, id, reach), box_(boxOf(surface[id])),
          widest_(range(0, box_.min().x(), box_.max().x())),
          window_(range(1, box_.min().y(), box_.max().y()),
                  range(2, box_.min().z(), box_.max().z())),
          isLarge_(window_.count() * (1 + static_cast<unsigned>(widest_[1] - widest_[0]) / 64) >
                   kLargeWindow)
    {
    }

    /// Looks for a row from number `row` on for which test(y, z, most) holds; the row has no cells
    /// but some of `most`. Leaves its number in `row`, or a greater one than any when there is
    /// none. Rows from the top down, as of a RowWindow, and of those the ones that are worth it:
    /// next(y, z, last, most). What a large window costs follows the triangle, not its box.
    template <class Test, class Next = EveryRow>
    bool find(std::uint64_t& row, Test&& test, Next&& next = {}) const
    {
        const CellRun widest = {widest_[0], widest_[1]};
        if (widest.first > widest.last)
        {
            return false;
        }
        return isLarge_ ? findInLarge(row, test, next)
                        : window_.find(
                              row, [&](int y, int z) { return test(y, z, widest); },
                              [&](int y, int z, int last) { return next(y, z, last, widest); });
    }
    /// The number of a row, or of the next one.
    [[nodiscard]] std::uint64_t numberFrom(CellRow row) const { return window_.numberFrom(row); }
    /// Calls visit(y, z, most) for all rows, likewise.
    template <class Visit, class Next = EveryRow>
    void forEach(Visit&& visit, Next&& next = {}) const
    {
        std::uint64_t row = 0;
        find(
            row,
            [&](int y, int z, CellRun most)
            {
                visit(y, z, most);
                return false;
            },
            next);
    }

    /// Those of a row's cells that may be near: their middle is near the triangle's plane and box.
    [[nodiscard]] CellRun run(int y, int z, CellRun most) const
    {
        const Eigen::Vector3d start = frame_.centre(0, y, z);
        const NearTriangle::Chord chord = near_.nearPlane(start.y(), start.z());
        const auto [first, last] = frame_.centresWithin(0, chord.from, chord.to);
        return {std::max({first, widest_[0], most.first}), std::min({last, widest_[1], most.last})};
    }

    [[nodiscard]] bool near(int x, int y, int z) const
    {
        return near_.contains(frame_.centre(x, y, z));
    }

private:
    static Eigen::AlignedBox3d boxOf(const SurfaceTriangle& triangle)
    {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& corner : triangle.corner)
        {
            box.extend(corner);
        }
        return box;
    }
    // Whatever is near a row is near the part of the triangle that is as high and as deep.
    template <class Test, class Next>
    bool findInLarge(std::uint64_t& row, Test& test, Next& next) const
    {
        const TrianglePart all(triangle_);
        while (row < window_.count())
        {
            const int y = window_.y(row);
            const TrianglePart layer = nearLayer(all, 1, y);
            const auto [low, high] = range(2, layer);
            for (int z = std::max(low, window_.z(row)); z <= high; ++z)
            {
                const auto x = range(0, nearLayer(layer, 2, z));
                row = window_.number(y, z);
                const CellRun most = {x[0], x[1]};
                if (x[0] <= x[1] && next(y, z, z, most) == z && test(y, z, most))
                {
                    return true;
                }
            }
            row = window_.number(y - 1, window_.z(0));
        }
        return false;
    }
    [[nodiscard]] TrianglePart nearLayer(const TrianglePart& part, int axis, int layer) const
    {
        const double middle = frame_.origin[axis] + (layer + 0.5) * frame_.cell;
        const double width = reach_ + kFilterRounding * frame_.cell;
        return part.between(axis, middle - width, middle + width);
    }
    [[nodiscard]] std::array<int, 2> range(int axis, const TrianglePart& part) const
    {
        const auto [low, high] = part.extent(axis);
        return range(axis, low - kFilterRounding * frame_.cell,
                     high + kFilterRounding * frame_.cell);
    }
    [[nodiscard]] std::array<int, 2> range(int axis, double low, double high) const
    {
        const double shift = -frame_.origin[axis] / frame_.cell - 0.5;
        return wholeNumbers((low - reach_) / frame_.cell + shift,
                            (high + reach_) / frame_.cell + shift, frame_.count[axis]);
    }

    GridFrame frame_;
    const SurfaceTriangle& triangle_;
    const TriangleBound& plane_;
    double reach_;
    NearTriangle near_;
    Eigen::AlignedBox3d box_;
    std::array<int, 2> widest_;
    RowWindow window_;
    bool isLarge_;
};

} // namespace frostfill
