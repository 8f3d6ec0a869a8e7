// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_grid.hpp"

#include "mesh/interior/near_surface.hpp"

#include <numeric>

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
    const auto enterGroup = [&](const TriangleGroup& group)
    {
        const NearGroup near(surface, group, reachOfCentre());
        const auto enter = [&](int x, int y, int z)
        {
            const std::size_t cell = cells_.obtain(x, y, z);
            starts_.resize(std::max(starts_.size(), cells_.size()), 0);
            for (const std::uint32_t t : group.triangles)
            {
                if (starts_[cell] <= kShortList &&
                    (group.triangles.size() == 1 || near.isNear(t, frame_.centre(x, y, z))))
                {
                    ++starts_[cell];
                    entries.push_back({static_cast<std::uint32_t>(cell), t});
                }
            }
        };
        forEachRunNear(frame_, surface, group, reachOfCentre(),
                       [&](int y, int z, CellRun run, auto&& isNear)
                       {
                           for (int x = run.first; x <= run.last; ++x)
                           {
                               const std::size_t cell = cells_.find(x, y, z);
                               if ((cell == Cells::kNone || starts_[cell] <= kShortList) &&
                                   isNear(x))
                               {
                                   enter(x, y, z);
                               }
                           }
                       });
    };
    forEachGroup(surface, frame.cell, enterGroup);

    // Sorts by the triangle, then by the cell: sums up the ends, and fills from them.
    std::vector<std::uint32_t> ends(surface.size() + 1);
    for (const Entry& each : entries)
    {
        ++ends[each.triangle];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint32_t> cells(entries.size());
    for (const Entry& each : entries)
    {
        cells[--ends[each.triangle]] = each.cell;
    }
    starts_.push_back(0);
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    ids_.resize(cells.size());
    for (std::size_t t = surface.size(); t-- > 0;)
    {
        for (std::uint32_t k = ends[t]; k < ends[t + 1]; ++k)
        {
            ids_[--starts_[cells[k]]] = static_cast<std::uint32_t>(t);
        }
    }
}

} // namespace frostfill
