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

/// Spheres that do not move, in columns by row, and by cell of a grid as linked lists of rows.
/// Cells are at least as large as the largest distance asked for.
class SphereGrid
{
public:
    explicit SphereGrid(const GridFrame& frame)
        : frame_(frame), cells_(frame.count), head_(cells_.size(), kEnd)
    {
    }

    /// Returns the row, which is the last.
    std::uint32_t insert(std::uint32_t id, const Eigen::Vector3d& p, double radius)
    {
        const auto row = static_cast<std::uint32_t>(size());
        balls_.push_back({p.x(), p.y(), p.z(), radius});
        rows_.push_back({id & kLargestId, false, kEnd});
        link(row);
        extent_.extend(p);
        return row;
    }

    /// Room for so many spheres without moving any in memory.
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

    // By row.
    [[nodiscard]] std::size_t size() const { return balls_.size(); }
    [[nodiscard]] const Ball& operator[](std::uint32_t row) const { return balls_[row]; }
    [[nodiscard]] std::uint32_t id(std::uint32_t row) const { return rows_[row].id; }
    /// Nothing can touch it any more.
    [[nodiscard]] bool isDiscarded(std::uint32_t row) const { return rows_[row].discarded; }
    void setDiscarded(std::uint32_t row, bool discarded) { rows_[row].discarded = discarded; }

    /// Calls visit(row) for each sphere in the cells that a ball of radius `reach` about p meets,
    /// and maybe for a few more.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        if (extent_.squaredExteriorDistance(p) > reach * reach)
        {
            return; // a fall begins far above all that is at rest
        }
        const auto low = frame_.coordinates(p.array() - reach);
        const auto high = frame_.coordinates(p.array() + reach);
        for (int z = low[2]; z <= high[2]; ++z)
        {
            const double dz = distanceToLayer(p, 2, z);
            for (int y = low[1]; y <= high[1]; ++y)
            {
                const double dy = distanceToLayer(p, 1, y);
                if (dz * dz + dy * dy <= reach * reach)
                {
                    cells_.forEachInRow(low[0], high[0], y, z, listOf(visit));
                }
            }
        }
    }

    /// Calls visit(row) for each sphere in the cells from `low` to `high`, both included.
    template <class Visit>
    void forEachIn(const std::array<int, 3>& low, const std::array<int, 3>& high,
                   Visit&& visit) const
    {
        cells_.forEachIn(low, high, listOf(visit));
    }
    /// The same for whole layers of cells, from `first` to `last` along z.
    template <class Visit>
    void forEachInLayers(int first, int last, Visit&& visit) const
    {
        cells_.forEachInLarge({0, 0, first}, {frame_.count[0] - 1, frame_.count[1] - 1, last},
                              listOf(visit));
    }

    [[nodiscard]] const GridFrame& frame() const { return frame_; }

private:
    /// Calls visit(row) for each sphere of a cell.
    template <class Visit>
    [[nodiscard]] auto listOf(Visit& visit) const
    {
        return [this, &visit](std::size_t cell)
        {
            for (std::uint32_t row = head_[cell]; row != kEnd; row = rows_[row].next)
            {
                visit(row);
            }
        };
    }
    /// From p to the nearest point of a layer of cells. Layers at the border reach to infinity.
    [[nodiscard]] double distanceToLayer(const Eigen::Vector3d& p, int axis, int layer) const
    {
        const double low = frame_.origin[axis] + frame_.cell * layer;
        const double below = layer > 0 ? low - p[axis] : 0;
        const double above = layer + 1 < frame_.count[axis] ? p[axis] - (low + frame_.cell) : 0;
        return std::max({0.0, below, above});
    }

    void link(std::uint32_t row)
    {
        const auto [x, y, z] = frame_.coordinates(balls_[row].position());
        const std::size_t cell = cells_.obtain(x, y, z);
        if (cell >= head_.size())
        {
            head_.resize(cells_.size(), kEnd);
        }
        rows_[row].next = std::exchange(head_[cell], row);
    }
    /// The link of its list that leads to the row.
    std::uint32_t& linkTo(std::uint32_t row)
    {
        const auto [x, y, z] = frame_.coordinates(balls_[row].position());
        std::uint32_t* link = &head_[cells_.find(x, y, z)];
        while (*link != row)
        {
            link = &rows_[*link].next;
        }
        return *link;
    }

    static constexpr std::uint32_t kEnd = 0xffffffff;
    static constexpr std::uint32_t kLargestId = 0x7fffffff;
    GridFrame frame_;
    BrickedCells<> cells_;
    std::vector<std::uint32_t> head_; ///< [#cells_]
    Eigen::AlignedBox3d extent_;      ///< of all that were ever inserted
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
