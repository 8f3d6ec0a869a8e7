// SPDX-License-Identifier: MIT
#include "mesh/interior/inside_test.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

/// Share of the reach of a cell's triangles within which another point lies surely on the same
/// side. Larger: rounding may put it beyond. Smaller: more points need a winding number.
constexpr double kNearlyAll = 0.99;

/// [1] of a cell, by which a point surely lies before the next one. Smaller: rounding puts it
/// there.
constexpr double kBorder = 1e-9;

} // namespace

/// Gives adjacent cells without triangles the same side. A block without triangles is one step.
class InsideTest::Flood
{
public:
    explicit Flood(InsideTest& test)
        : test_(test), grid_(*test.grid_), blockKnown_(grid_.blocksFrame().size(), false),
          cellKnown_(TriangleGrid::kInBlock * grid_.blocksWithTriangles(), false)
    {
    }

    void fromBlock(const Cell& block)
    {
        constexpr int kSide = TriangleGrid::kSide;
        const Cell first = {block[0] * kSide, block[1] * kSide, block[2] * kSide};
        const bool one = grid_.blockOf(first[0], first[1], first[2]) == TriangleGrid::kNoTriangles;
        for (int i = 0; i < (one ? 1 : kSide * kSide * kSide); ++i)
        {
            from({first[0] + i % kSide, first[1] + i / kSide % kSide,
                  first[2] + i / (kSide * kSide)});
        }
    }

private:
    void from(const Cell& seed)
    {
        if (!isInFrame(seed) || isKnown(seed))
        {
            return;
        }
        const bool side = test_.isInsideByWinding(grid_.frame().centre(seed[0], seed[1], seed[2]));
        waiting_.push_back(seed);
        while (!waiting_.empty())
        {
            const Cell cell = waiting_.back();
            waiting_.pop_back();
            if (!isKnown(cell))
            {
                const bool isBlock = mark(cell, side);
                isBlock ? addNeighboursOfBlock(cell) : addNeighbours(cell);
            }
        }
    }

    /// Whether the side of the cell is known, or is none because the cell has triangles.
    [[nodiscard]] bool isKnown(const Cell& cell) const
    {
        const auto [x, y, z] = cell;
        const std::uint32_t block = grid_.blockOf(x, y, z);
        return block == TriangleGrid::kNoTriangles
                   ? blockKnown_[grid_.blockIndex(x, y, z)]
                   : cellKnown_[TriangleGrid::cellIndex(block, x, y, z)] ||
                         !grid_.cell(x, y, z).empty();
    }
    /// Returns whether the cell stands for its block.
    bool mark(const Cell& cell, bool side)
    {
        const auto [x, y, z] = cell;
        const std::uint32_t block = grid_.blockOf(x, y, z);
        if (block == TriangleGrid::kNoTriangles)
        {
            blockKnown_[grid_.blockIndex(x, y, z)] = true;
            test_.blockInside_[grid_.blockIndex(x, y, z)] = side;
            return true;
        }
        cellKnown_[TriangleGrid::cellIndex(block, x, y, z)] = true;
        test_.cellInside_[TriangleGrid::cellIndex(block, x, y, z)] = side;
        return false;
    }
    [[nodiscard]] bool isInFrame(const Cell& cell) const
    {
        const auto& count = grid_.frame().count;
        return cell[0] >= 0 && cell[0] < count[0] && cell[1] >= 0 && cell[1] < count[1] &&
               cell[2] >= 0 && cell[2] < count[2];
    }
    void add(const Cell& cell)
    {
        if (isInFrame(cell) && !isKnown(cell))
        {
            waiting_.push_back(cell);
        }
    }
    void addNeighbours(const Cell& cell)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            for (const int step : {-1, 1})
            {
                Cell other = cell;
                other[axis] += step;
                add(other);
            }
        }
    }
    void addNeighboursOfBlock(Cell cell)
    {
        constexpr int kSide = TriangleGrid::kSide;
        for (int& coordinate : cell)
        {
            coordinate -= coordinate % kSide;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            for (const int step : {-1, kSide})
            {
                Cell other = cell;
                other[axis] += step;
                addSide(other, axis);
            }
        }
    }
    /// Adds the cells of a neighbouring block that touch this one, the first of which is given.
    void addSide(const Cell& first, int axis)
    {
        constexpr int kSide = TriangleGrid::kSide;
        if (!isInFrame(first))
        {
            return;
        }
        const bool one = grid_.blockOf(first[0], first[1], first[2]) == TriangleGrid::kNoTriangles;
        for (int i = 0; i < (one ? 1 : kSide * kSide); ++i)
        {
            Cell cell = first;
            cell[(axis + 1) % 3] += i % kSide;
            cell[(axis + 2) % 3] += i / kSide;
            add(cell);
        }
    }
    InsideTest& test_;
    const TriangleGrid& grid_;
    std::vector<bool> blockKnown_, cellKnown_;
    std::vector<Cell> waiting_;
};

// Adjacent cells without triangles are on the same side, so one winding number serves all of them.
InsideTest::InsideTest(const Surface& surface, const TriangleGrid& grid)
    : surface_(&surface), grid_(&grid), winding_(surface.mesh()),
      blockInside_(grid.blocksFrame().size(), false),
      cellInside_(TriangleGrid::kInBlock * grid.blocksWithTriangles(), false)
{
    Flood flood(*this);
    const auto& blocks = grid.blocksFrame().count;
    for (int z = 0; z < blocks[2]; ++z)
    {
        for (int y = 0; y < blocks[1]; ++y)
        {
            for (int x = 0; x < blocks[0]; ++x)
            {
                flood.fromBlock({x, y, z});
            }
        }
    }
}

bool InsideTest::isCellInside(const Cell& cell) const
{
    const auto [x, y, z] = cell;
    const std::uint32_t block = grid_->blockOf(x, y, z);
    return block == TriangleGrid::kNoTriangles
               ? blockInside_[grid_->blockIndex(x, y, z)]
               : cellInside_[TriangleGrid::cellIndex(block, x, y, z)];
}

double InsideTest::farOutsideUntil(const Eigen::Vector3d& p) const
{
    const GridFrame& frame = grid_->frame();
    auto [x, y, z] = frame.coordinates(p);
    const int first = x;
    while (x < frame.count[0] && grid_->blockOf(x, y, z) == TriangleGrid::kNoTriangles &&
           !isCellInside({x, y, z}))
    {
        x += TriangleGrid::kSide - x % TriangleGrid::kSide;
    }
    return x == first ? p.x() : frame.origin.x() + frame.cell * (x - kBorder);
}

bool InsideTest::contains(const Eigen::Vector3d& p) const
{
    return distance(p) > 0;
}

double InsideTest::distance(const Eigen::Vector3d& p, double atMost) const
{
    const double reach = grid_->reach();
    const std::span<const std::uint32_t> triangles = grid_->near(p);
    if (triangles.empty())
    {
        return isCellInside(grid_->frame().coordinates(p)) ? reach : -reach;
    }
    // The nearest triangle of the list is the nearest of all if it is within the reach of the list.
    const double nearest = grid_->nearest(p, triangles, atMost).value;
    if (std::abs(nearest) > reach)
    {
        return isInsideFarFromSurface(p) ? reach : -reach;
    }
    if (surface_->anyTwoSided() && isNearTwoSided(p))
    {
        return isInsideByWinding(p) ? std::abs(nearest) : -std::abs(nearest);
    }
    return nearest;
}

bool InsideTest::isNearTwoSided(const Eigen::Vector3d& p) const
{
    std::vector<std::uint32_t> found;
    const auto near = grid_->near(p, grid_->reach(), found);
    return std::any_of(near.begin(), near.end(),
                       [this](std::uint32_t id) { return (*surface_)[id].twoSided; });
}

// No surface is within the reach of p, so every point within that distance is on the same side as
// p. Some of these points are in classified cells.
bool InsideTest::isInsideFarFromSurface(const Eigen::Vector3d& p) const
{
    for (int direction = 0; direction < 6; ++direction)
    {
        Eigen::Vector3d other = p;
        other[direction / 2] += (direction % 2 == 0 ? -1 : 1) * kNearlyAll * grid_->reach();
        if (grid_->near(other).empty() && grid_->frame().contains(other))
        {
            return isCellInside(grid_->frame().coordinates(other));
        }
    }
    return isInsideByWinding(p);
}

} // namespace frostfill
