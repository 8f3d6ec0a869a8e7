// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_grid.hpp"

#include "mesh/interior/near_surface.hpp"

namespace frostfill
{

// A list that is long already does not grow, so what a dense patch costs follows the cells, not its
// triangles.
TriangleGrid::TriangleGrid(const Surface& surface, const GridFrame& frame, double reach)
    : surface_(&surface), frame_(frame), reach_(reach), cells_(frame.count, 0)
{
    struct Entry
    {
        std::uint32_t cell;
        std::uint32_t triangle;
    };
    std::vector<Entry> entries;
    std::vector<std::uint32_t> counts; // [#cells_]
    const auto enterGroup = [&](const TriangleGroup& group)
    {
        const NearGroup near(surface, group, reachOfCentre());
        const bool isAlone = group.triangles.size() == 1;
        const auto enter = [&](int x, int y, int z)
        {
            std::size_t cell = cells_.find(x, y, z);
            const Eigen::Vector3d centre = frame_.centre(x, y, z);
            for (const std::uint32_t t : group.triangles)
            {
                if (cell != Cells::kNone && counts[cell] > kShortList)
                {
                    return;
                }
                if (isAlone || near.isNear(t, centre))
                {
                    cell = cells_.obtain(x, y, z);
                    counts.resize(cells_.size(), 0);
                    ++counts[cell];
                    entries.push_back({static_cast<std::uint32_t>(cell), t});
                }
            }
        };
        const auto enterRun = [&](int y, int z, CellRun run, auto&& isNear)
        {
            // The surroundings of a triangle are convex: between two near cells all are near.
            while (isAlone && run.first <= run.last && !isNear(run.first))
            {
                ++run.first;
            }
            while (isAlone && run.first < run.last && !isNear(run.last))
            {
                --run.last;
            }
            for (int x = run.first; x <= run.last; ++x)
            {
                enter(x, y, z);
            }
        };
        forEachRunNear(frame_, surface, group, reachOfCentre(), enterRun);
    };
    Threads one(1); // groups are entered in their order
    forEachGroup(surface, 2 * frame.cell, one, enterGroup);

    // By the triangle, then by the cell.
    const Buckets<std::uint32_t> cellsOf(surface.size(),
                                         [&](auto&& enter)
                                         {
                                             for (const Entry& each : entries)
                                             {
                                                 enter(each.triangle, each.cell);
                                             }
                                         });
    lists_ = Buckets<std::uint32_t>(cells_.size(),
                                    [&](auto&& enter)
                                    {
                                        for (std::uint32_t t = 0; t < surface.size(); ++t)
                                        {
                                            for (const std::uint32_t cell : cellsOf[t])
                                            {
                                                enter(cell, t);
                                            }
                                        }
                                    });
}

} // namespace frostfill
