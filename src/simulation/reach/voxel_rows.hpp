// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/reach/voxel_layout.hpp"

#include <cmath>
#include <limits>

/// Which cubes lie in a ball, near a ball or near a triangle, row by row.
namespace frostfill
{

/// Cubes first..last of a row; none when last < first.
struct VoxelRun
{
    int first;
    int last;
};

/// Whole numbers low..high that lie in [from, to] and are the number of a cube, without calls.
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

/// A window of rows, numbered from the top down. Holes in a pile close from below, so the topmost
/// reached cube near an obstacle is the last to go: a search that starts there resumes least.
class RowWindow
{
public:
    RowWindow(std::array<int, 2> y, std::array<int, 2> z)
        : top_(y[1]), firstZ_(z[0]), depth_(z[1] - z[0] + 1),
          count_(y[1] < y[0] || depth_ < 1
                     ? 0
                     : static_cast<std::uint32_t>(y[1] - y[0] + 1) * static_cast<unsigned>(depth_))
    {
    }
    /// Looks for a row from number `row` on for which test(y, z) holds. Leaves its number in `row`,
    /// or the number of rows when there is none.
    template <class Test>
    bool find(std::uint32_t& row, Test&& test) const
    {
        if (row >= count_)
        {
            return false;
        }
        int y = top_ - static_cast<int>(row / static_cast<unsigned>(depth_));
        int z = firstZ_ + static_cast<int>(row % static_cast<unsigned>(depth_));
        for (; row < count_; ++row)
        {
            if (test(y, z))
            {
                return true;
            }
            if (++z == firstZ_ + depth_)
            {
                z = firstZ_;
                --y;
            }
        }
        return false;
    }

    template <class Visit>
    void forEach(Visit&& visit) const
    {
        std::uint32_t row = 0;
        find(row,
             [&](int y, int z)
             {
                 visit(y, z);
                 return false;
             });
    }

private:
    int top_;
    int firstZ_;
    int depth_;
    std::uint32_t count_;
};

/// Which cubes of a grid belong to a ball, by what is added to the distance of their middle along
/// each axis.
inline constexpr double kInsideBall = 0.5; ///< the farthest corner is within the radius
inline constexpr double kMeetsBall = -0.5; ///< the nearest point is
/// The cubes of a grid about a ball.
class BallRows
{
public:
    BallRows(const GridFrame& frame, const Eigen::Vector3d& centre, double radius, double half)
        : count_(frame.count), centre_(((centre - frame.origin) / frame.cell).array() - 0.5),
          radius_(radius / frame.cell), half_(half), widest_(range(0, radius_ - half)),
          window_(range(1, radius_ - half), range(2, radius_ - half))
    {
    }
    [[nodiscard]] const RowWindow& window() const { return window_; }

    /// What no row has more cubes than.
    [[nodiscard]] VoxelRun widest() const { return {widest_[0], widest_[1]}; }

    [[nodiscard]] VoxelRun run(int y, int z) const
    {
        const double dy = std::max(0.0, std::abs(y - centre_.y()) + half_);
        const double dz = std::max(0.0, std::abs(z - centre_.z()) + half_);
        const double rest = radius_ * radius_ - dy * dy - dz * dz;
        if (rest < 0)
        {
            return {0, -1};
        }
        const auto x = range(0, std::sqrt(rest) - half_);
        return {x[0], x[1]};
    }

private:
    [[nodiscard]] std::array<int, 2> range(int axis, double reach) const
    {
        return wholeNumbers(centre_[axis] - reach, centre_[axis] + reach, count_[axis]);
    }

    std::array<int, 3> count_;
    Eigen::Vector3d centre_; ///< in cubes, counted from the middle of cube 0
    double radius_;          ///< in cubes
    double half_;
    std::array<int, 2> widest_;
    RowWindow window_;
};

/// The cubes of a grid whose middle is within `reach` of a triangle.
class TriangleRows
{
public:
    TriangleRows(const GridFrame& frame, const Surface& surface, std::uint32_t id, double reach)
        : frame_(frame), triangle_(surface[id]), plane_(surface.bound(id)), reach_(reach),
          box_(boxOf(surface[id])), widest_(range(0, box_.min().x(), box_.max().x())),
          window_(range(1, box_.min().y(), box_.max().y()),
                  range(2, box_.min().z(), box_.max().z()))
    {
    }
    [[nodiscard]] const RowWindow& window() const { return window_; }

    /// What no row has more cubes than.
    [[nodiscard]] VoxelRun widest() const { return {widest_[0], widest_[1]}; }

    /// The cubes of a row that may be near: their middle is near the triangle's plane and box.
    [[nodiscard]] VoxelRun run(int y, int z) const
    {
        double low = box_.min().x();
        double high = box_.max().x();
        const Eigen::Vector3d start = frame_.centre(0, y, z);
        const double slope = plane_.normal.x();
        if (std::abs(slope) > kSteep)
        {
            // |n.p - offset| <= reach on the line p = start + t e_x; x shifted by -reach below.
            const double middle = start.x() - (plane_.normal.dot(start) - plane_.offset) / slope;
            const double width = (reach_ + kFilterRounding) / std::abs(slope);
            low = std::max(low, middle - width + reach_);
            high = std::min(high, middle + width - reach_);
        }
        const auto x = range(0, low, high);
        return {x[0], x[1]};
    }

    [[nodiscard]] bool near(int x, int y, int z) const
    {
        const Eigen::Vector3d p = frame_.centre(x, y, z);
        const auto& [a, b, c] = triangle_.corner;
        return (closestPointOnTriangle(p, a, b, c).point - p).squaredNorm() <= reach_ * reach_;
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
    Eigen::AlignedBox3d box_;
    std::array<int, 2> widest_;
    RowWindow window_;
};

} // namespace frostfill
