// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace frostfill
{

/// Centre and radius: all that a search reads of a sphere, in one place of memory.
struct alignas(32) Ball
{
    double x = 0, y = 0, z = 0;
    double radius = 0;

    [[nodiscard]] Eigen::Vector3d position() const { return {x, y, z}; }
};

/// Spheres, in columns by row, and by cell of a grid as linked lists of rows. Cells are at least as
/// large as the largest distance asked for. One grid has the spheres at rest. Another has the
/// running spheres, by their rows, at the places that they had when it was filled.
///
/// Where sizes differ much there are grids with levels: the spheres of at most half the largest
/// radius are in a grid of half the cell, and so on. A search asks each level for what it can hold.
class SphereGrid
{
public:
    /// `levels`: grids besides that of the frame, each with half the cell of the one before.
    explicit SphereGrid(const GridFrame& frame, int levels = 0) : coarse_(frame, 1)
    {
        GridFrame fine = frame;
        double largest = 1;
        for (int level = 0; level < levels; ++level)
        {
            fine.cell /= 2;
            largest /= 2;
            for (int& count : fine.count)
            {
                count *= 2;
            }
            finer_.emplace_back(fine, largest);
        }
    }

    /// Returns the row, which is the last.
    std::uint32_t insert(std::uint32_t id, const Eigen::Vector3d& p, double radius)
    {
        const auto row = static_cast<std::uint32_t>(size());
        balls_.push_back({p.x(), p.y(), p.z(), radius});
        rows_.push_back({id & kLargestId, false, kEnd});
        link(row);
        return row;
    }

    /// Room for so many spheres without moving any.
    void reserve(std::size_t count)
    {
        balls_.reserve(count);
        rows_.reserve(count);
    }

    /// Takes out a row; the last one takes its place.
    void remove(std::uint32_t row)
    {
        linkTo(row) = rows_[row].next;
        const auto last = static_cast<std::uint32_t>(size() - 1);
        if (row != last)
        {
            linkTo(last) = row;
            balls_[row] = balls_[last];
            rows_[row] = rows_[last];
        }
        balls_.pop_back();
        rows_.pop_back();
    }

    /// The sphere has got another id. It is met first in its cell from now on, as one that has just
    /// come to rest.
    void renumber(std::uint32_t row, std::uint32_t id)
    {
        rows_[row].id = id & kLargestId;
        linkTo(row) = rows_[row].next;
        link(row);
    }

    /// The sphere is elsewhere now.
    void move(std::uint32_t row, const Eigen::Vector3d& p)
    {
        linkTo(row) = rows_[row].next;
        balls_[row] = {p.x(), p.y(), p.z(), balls_[row].radius};
        link(row);
    }
    /// Takes out all. Takes time with the spheres, not the cells.
    void clear()
    {
        for (const Ball& ball : balls_)
        {
            headOf(ball) = kEnd;
        }
        balls_.clear();
        rows_.clear();
        coarse_.extent.setEmpty();
        for (Level& level : finer_)
        {
            level.extent.setEmpty();
        }
    }

    // By row.
    [[nodiscard]] std::size_t size() const { return balls_.size(); }
    [[nodiscard]] const Ball& operator[](std::uint32_t row) const { return balls_[row]; }
    [[nodiscard]] std::uint32_t id(std::uint32_t row) const { return rows_[row].id; }
    /// Nothing touches it any more.
    [[nodiscard]] bool isDiscarded(std::uint32_t row) const { return rows_[row].discarded; }
    void discard(std::uint32_t row) { rows_[row].discarded = true; }

    /// Calls visit(row) for each sphere in the cells that a box of `reach` about p meets: to leave
    /// out cells at its corners takes longer than to look at them. `reach` is meant for the largest
    /// spheres, whose radius is 1: of a smaller one the centre is looked for as much nearer as its
    /// radius is smaller.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        forEachNearIn(coarse_, p, reach, visit);
        for (const Level& level : finer_)
        {
            forEachNearIn(level, p, reach - 1 + level.largest, visit);
        }
    }

    /// Calls visit(row) for each sphere in the cells of a level from `low` to `high`, both
    /// included.
    template <class Visit>
    void forEachIn(const std::array<int, 3>& low, const std::array<int, 3>& high, Visit&& visit,
                   std::size_t level = 0) const
    {
        const Level& one = levelAt(level);
        one.cells.forEachIn(low, high, listOf(one, visit));
    }

    /// Of the coarsest level.
    [[nodiscard]] const GridFrame& frame() const { return coarse_.frame; }
    [[nodiscard]] std::size_t levels() const { return 1 + finer_.size(); }
    [[nodiscard]] const GridFrame& frame(std::size_t level) const { return levelAt(level).frame; }
    /// No centre in a level is higher than this.
    [[nodiscard]] double top(std::size_t level) const { return levelAt(level).extent.max().y(); }
    /// The largest radius of a level.
    [[nodiscard]] double largest(std::size_t level) const { return levelAt(level).largest; }
    /// The level that spheres of a radius are in.
    [[nodiscard]] std::size_t levelFor(double radius) const
    {
        std::size_t level = 0;
        while (level < finer_.size() && radius <= finer_[level].largest)
        {
            ++level;
        }
        return level;
    }

private:
    struct Level
    {
        Level(const GridFrame& frameOfLevel, double largestRadius)
            : frame(frameOfLevel), largest(largestRadius), cells(frame.count),
              head(cells.size(), kEnd)
        {
        }

        GridFrame frame;
        double largest;
        BrickedCells<> cells;
        std::vector<std::uint32_t> head; ///< [#cells]
        Eigen::AlignedBox3d extent;      ///< of all that were ever inserted
    };

    [[nodiscard]] const Level& levelAt(std::size_t level) const
    {
        return level == 0 ? coarse_ : finer_[level - 1];
    }
    [[nodiscard]] Level& levelOf(double radius)
    {
        const std::size_t level = levelFor(radius);
        return level == 0 ? coarse_ : finer_[level - 1];
    }

    template <class Visit>
    void forEachNearIn(const Level& level, const Eigen::Vector3d& p, double reach,
                       Visit& visit) const
    {
        if (level.extent.squaredExteriorDistance(p) <= reach * reach) // a fall begins far above
        {
            level.cells.forEachIn(level.frame.coordinates(p.array() - reach),
                                  level.frame.coordinates(p.array() + reach), listOf(level, visit));
        }
    }
    /// Calls visit(row) for each sphere of a cell.
    template <class Visit>
    [[nodiscard]] auto listOf(const Level& level, Visit& visit) const
    {
        return [this, &level, &visit](std::size_t cell)
        {
            for (std::uint32_t row = level.head[cell]; row != kEnd; row = rows_[row].next)
            {
                visit(row);
            }
        };
    }

    void link(std::uint32_t row)
    {
        const Eigen::Vector3d p = balls_[row].position();
        Level& level = levelOf(balls_[row].radius);
        level.extent.extend(p);
        const auto [x, y, z] = level.frame.coordinates(p);
        const std::size_t cell = level.cells.obtain(x, y, z);
        if (cell >= level.head.size())
        {
            level.head.resize(level.cells.size(), kEnd);
        }
        rows_[row].next = std::exchange(level.head[cell], row);
    }
    /// The head of the list that a sphere of the grid is in.
    std::uint32_t& headOf(const Ball& ball)
    {
        Level& level = levelOf(ball.radius);
        const auto [x, y, z] = level.frame.coordinates(ball.position());
        return level.head[level.cells.find(x, y, z)];
    }
    /// The link of its list that leads to the row.
    std::uint32_t& linkTo(std::uint32_t row)
    {
        std::uint32_t* link = &headOf(balls_[row]);
        while (*link != row)
        {
            link = &rows_[*link].next;
        }
        return *link;
    }

    static constexpr std::uint32_t kEnd = 0xffffffff;
    static constexpr std::uint32_t kLargestId = 0x7fffffff;
    Level coarse_;
    std::vector<Level> finer_;
    std::vector<Ball> balls_;
    struct Row
    {
        std::uint32_t id : 31;
        bool discarded : 1;
        std::uint32_t next; ///< row in the list of its cell
    };
    std::vector<Row> rows_;
};

} // namespace frostfill
