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

/// Gives adjacent cells without triangles the same side. A brick without triangles is one step.
/// Outside, a flood stays beside bricks with triangles, so that its cost follows the object, not
/// the box around it: what is farther away and not inside is outside.
class InsideTest::Flood
{
public:
    explicit Flood(InsideTest& test)
        : test_(test), grid_(*test.grid_), cells_(grid_.cells()), cellKnown_(cells_.size(), false)
    {
    }

    void run()
    {
        for (std::size_t brick = 0; brick < cells_.bricks().size(); ++brick)
        {
            forEachBeside(cells_.bricks().place(brick),
                          [&](const GridPlace& other) { (void)test_.sideOfBrick(other); });
        }
        for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        {
            from(cells_.cell(cell));
        }
        for (std::size_t brick = 0; brick < test_.far_.size(); ++brick) // inside there come more
        {
            from(firstCellOf(test_.far_.place(brick)));
        }
    }

private:
    static constexpr int kSide = TriangleGrid::Cells::kSide;
    static_assert(kSide == TriangleGrid::Cells::kLength);

    static Cell firstCellOf(const GridPlace& brick)
    {
        return {brick[0] * kSide, brick[1] * kSide, brick[2] * kSide};
    }
    /// Calls visit(place) for the bricks without triangles that share a face with one.
    template <class Visit>
    void forEachBeside(const GridPlace& brick, Visit&& visit)
    {
        for (int face = 0; face < 6; ++face)
        {
            GridPlace other = brick;
            other[face / 2] += face % 2 == 0 ? -1 : 1;
            if (cells_.bricks().isInBox(other) &&
                cells_.bricks().find(other[0], other[1], other[2]) == BrickTable::kNone)
            {
                visit(other);
            }
        }
    }

    void from(const Cell& seed)
    {
        if (!cells_.isInGrid(seed) || isKnown(seed))
        {
            return;
        }
        side_ = test_.isInsideByWinding(grid_.frame().centre(seed[0], seed[1], seed[2]))
                    ? Side::inside
                    : Side::outside;
        waiting_.push_back(seed);
        while (!waiting_.empty())
        {
            const Cell cell = waiting_.back();
            waiting_.pop_back();
            if (!isKnown(cell))
            {
                const bool isBrick = mark(cell);
                isBrick ? addNeighboursOfBrick(cell) : addNeighbours(cell);
            }
        }
    }

    [[nodiscard]] bool hasTriangles(const Cell& cell) const // or its brick has
    {
        return cells_.find(cell[0], cell[1], cell[2]) != TriangleGrid::Cells::kNone;
    }
    /// Whether the side of the cell is known, or is none because the cell has triangles, or is not
    /// asked for.
    [[nodiscard]] bool isKnown(const Cell& cell) const
    {
        const std::size_t number = cells_.find(cell[0], cell[1], cell[2]);
        if (number != TriangleGrid::Cells::kNone)
        {
            return cellKnown_[number] || !grid_.ofCell(number).empty();
        }
        const std::uint32_t far = test_.farBrick(cell);
        return far == BrickTable::kNone ? side_ == Side::outside
                                        : test_.farSide_[far] != Side::unknown;
    }
    /// Returns whether the cell stands for its brick.
    bool mark(const Cell& cell)
    {
        const std::size_t number = cells_.find(cell[0], cell[1], cell[2]);
        if (number == TriangleGrid::Cells::kNone)
        {
            test_.sideOfBrick(TriangleGrid::Cells::brickOf(cell)) = side_;
            return true;
        }
        cellKnown_[number] = true;
        test_.cellInside_[number] = side_ == Side::inside;
        return false;
    }
    void add(const Cell& cell)
    {
        if (cells_.isInGrid(cell) && !isKnown(cell))
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
    void addNeighboursOfBrick(Cell cell)
    {
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
    /// Adds the cells of a neighbouring brick that touch this one, the first of which is given.
    void addSide(const Cell& first, int axis)
    {
        if (!cells_.isInGrid(first))
        {
            return;
        }
        for (int i = 0; i < (hasTriangles(first) ? kSide * kSide : 1); ++i)
        {
            Cell cell = first;
            cell[(axis + 1) % 3] += i % kSide;
            cell[(axis + 2) % 3] += i / kSide;
            add(cell);
        }
    }
    InsideTest& test_;
    const TriangleGrid& grid_;
    const TriangleGrid::Cells& cells_;
    std::vector<bool> cellKnown_;
    Side side_ = Side::unknown; ///< of the flood
    std::vector<Cell> waiting_;
};

// Adjacent cells without triangles are on the same side, so one winding number serves all of them.
InsideTest::InsideTest(const Surface& surface, const TriangleGrid& grid)
    : surface_(&surface), grid_(&grid), winding_(surface.mesh()),
      far_(grid.cells().bricks().count()), cellInside_(grid.cells().size(), false)
{
    Flood(*this).run();
}

InsideTest::Side& InsideTest::sideOfBrick(const GridPlace& brick)
{
    const std::uint32_t far = far_.obtain(brick[0], brick[1], brick[2]);
    farSide_.resize(far_.size(), Side::unknown);
    return farSide_[far];
}

std::uint32_t InsideTest::farBrick(const Cell& cell) const
{
    const GridPlace brick = TriangleGrid::Cells::brickOf(cell);
    return far_.find(brick[0], brick[1], brick[2]);
}

bool InsideTest::isCellInside(const Cell& cell) const
{
    const std::size_t number = grid_->cells().find(cell[0], cell[1], cell[2]);
    if (number != TriangleGrid::Cells::kNone)
    {
        return cellInside_[number];
    }
    const std::uint32_t far = farBrick(cell);
    return far != BrickTable::kNone && farSide_[far] == Side::inside;
}

Eigen::AlignedBox3d InsideTest::boxInReach(std::size_t brick) const
{
    const TriangleGrid::Cells& cells = grid_->cells();
    const double half = grid_->frame().cell / 2;
    Eigen::AlignedBox3d box;
    const std::size_t first = brick * TriangleGrid::Cells::kInBrick;
    for (std::size_t cell = first; cell < first + TriangleGrid::Cells::kInBrick; ++cell)
    {
        if (cellInside_[cell] || !grid_->ofCell(cell).empty())
        {
            const auto [x, y, z] = cells.cell(cell);
            const Eigen::Vector3d middle = grid_->frame().centre(x, y, z);
            box.extend(Eigen::Vector3d(middle.array() - half));
            box.extend(Eigen::Vector3d(middle.array() + half));
        }
    }
    return box;
}

bool InsideTest::contains(const Eigen::Vector3d& p) const
{
    return distance(p) > 0;
}

// The nearest triangle of the list is the nearest of all if it is within the reach of the list.
bool InsideTest::contains(const Eigen::Vector3d& p, const SignedDistance& nearest) const
{
    if (std::abs(nearest.value) > reach())
    {
        return isInsideFarFromSurface(p);
    }
    return isNearTwoSided(p) ? isInsideByWinding(p) : nearest.value > 0;
}

double InsideTest::distance(const Eigen::Vector3d& p, double atMost) const
{
    const std::span<const std::uint32_t> triangles = grid_->near(p);
    if (triangles.empty())
    {
        return isCellInside(grid_->frame().coordinates(p)) ? reach() : -reach();
    }
    const SignedDistance nearest = grid_->nearest(p, triangles, atMost);
    const double distance = std::min(std::abs(nearest.value), reach());
    return contains(p, nearest) ? distance : -distance;
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

bool InsideTest::isNearTwoSided(const Eigen::Vector3d& p) const
{
    const auto isTwoSided = [this](std::uint32_t id) { return (*surface_)[id].twoSided; };
    if (!surface_->anyTwoSided())
    {
        return false;
    }
    const std::span<const std::uint32_t> all = grid_->near(p);
    if (all.size() <= TriangleGrid::kShortList)
    {
        return std::any_of(all.begin(), all.end(), isTwoSided);
    }
    bool isNear = false; // once one is, the others of its leaf come, too
    surface_->tree().forEachTriangleNear(p, reach(),
                                         [&](std::uint32_t id)
                                         {
                                             isNear = isTwoSided(id) || isNear;
                                             return isNear ? -1 : reach();
                                         });
    return isNear;
}

} // namespace frostfill
