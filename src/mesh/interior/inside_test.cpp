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

} // namespace

InsideTest::InsideTest(const Surface& surface, const TriangleGrid& grid)
    : surface_(&surface), grid_(&grid), winding_(surface.mesh()),
      inside_(grid.frame().size(), false)
{
    const GridFrame& frame = grid.frame();
    std::vector<bool> known(frame.size(), false);
    std::size_t cell = 0;
    for (int z = 0; z < frame.count[2]; ++z)
    {
        for (int y = 0; y < frame.count[1]; ++y)
        {
            for (int x = 0; x < frame.count[0]; ++x, ++cell)
            {
                if (!known[cell] && grid.cell(x, y, z).empty())
                {
                    classifyFrom({x, y, z}, known);
                }
            }
        }
    }
}

// Adjacent cells without triangles are on the same side, so one winding number serves all of them.
// The flood goes by runs of a row, which keeps the stack short [Smith 1979].
void InsideTest::classifyFrom(const std::array<int, 3>& seed, std::vector<bool>& known)
{
    const GridFrame& frame = grid_->frame();
    const bool side = isInsideByWinding(frame.centre(seed[0], seed[1], seed[2]));
    const auto isNew = [&](int x, int y, int z)
    { return !known[frame.index(x, y, z)] && grid_->cell(x, y, z).empty(); };
    std::vector<std::array<int, 3>> waiting = {seed};
    while (!waiting.empty())
    {
        const auto [x, y, z] = waiting.back();
        waiting.pop_back();
        int first = x;
        while (first > 0 && isNew(first - 1, y, z))
        {
            --first;
        }
        int end = x;
        for (; end < frame.count[0] && (end < x || isNew(end, y, z)); ++end)
        {
        }
        for (int k = first; k < end; ++k)
        {
            known[frame.index(k, y, z)] = true;
            inside_[frame.index(k, y, z)] = side;
        }
        for (const auto& [ny, nz] : {std::array{y - 1, z}, {y + 1, z}, {y, z - 1}, {y, z + 1}})
        {
            if (ny < 0 || ny >= frame.count[1] || nz < 0 || nz >= frame.count[2])
            {
                continue;
            }
            bool inRun = false;
            for (int k = first; k < end; ++k)
            {
                const bool fresh = isNew(k, ny, nz);
                if (fresh && !inRun)
                {
                    waiting.push_back({k, ny, nz});
                }
                inRun = fresh;
            }
        }
    }
}

bool InsideTest::contains(const Eigen::Vector3d& p) const
{
    return distance(p) > 0;
}

double InsideTest::distance(const Eigen::Vector3d& p) const
{
    const double reach = grid_->reach();
    const std::span<const std::uint32_t> triangles = grid_->near(p);
    if (triangles.empty())
    {
        return inside_[grid_->frame().index(p)] ? reach : -reach;
    }
    // The nearest triangle of the list is the nearest of all if it is within the reach of the list.
    const double nearest = nearestDistance(*surface_, triangles, p).value;
    if (std::abs(nearest) > reach)
    {
        return isInsideFarFromSurface(p) ? reach : -reach;
    }
    const auto isTwoSided = [this](std::uint32_t id) { return (*surface_)[id].twoSided; };
    if (surface_->anyTwoSided() && std::any_of(triangles.begin(), triangles.end(), isTwoSided))
    {
        return isInsideByWinding(p) ? std::abs(nearest) : -std::abs(nearest);
    }
    return nearest;
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
            return inside_[grid_->frame().index(other)];
        }
    }
    // Two such points of one cell are closer to each other than twice the reach. No surface is
    // between them, so one winding number serves the cell.
    const std::lock_guard lock(*farSidesLock_);
    const auto [side, isNew] = farSides_.try_emplace(grid_->frame().index(p), false);
    if (isNew)
    {
        side->second = isInsideByWinding(p);
    }
    return side->second;
}

} // namespace frostfill
