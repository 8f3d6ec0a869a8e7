// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/group_rows.hpp"
#include "mesh/interior/triangle_rows.hpp"

namespace frostfill
{

/// Finds the cells of a grid whose middle is within `distance` of some triangles that lie side by
/// side, or of one. Calls visit(y, z, run, isNear) for rows with a run of cells that may be, of
/// which isNear(x) tells. Of one triangle only rows that are worth it: next(y, z, last, most), as
/// of TriangleRows.
template <class Visit, class Next = EveryRow>
void forEachRunNear(const GridFrame& frame, const Surface& surface, const TriangleGroup& group,
                    double distance, Visit&& visit, Next&& next = {})
{
    if (group.triangles.size() > 1)
    {
        const GroupRows rows(frame, surface, group, distance);
        rows.forEach([&](int y, int z, CellRun run)
                     { visit(y, z, run, [&](int x) { return rows.near(x, y, z); }); });
        return;
    }
    const TriangleRows rows(frame, surface, group.triangles[0], distance);
    rows.forEach([&](int y, int z, CellRun most)
                 { visit(y, z, rows.run(y, z, most), [&](int x) { return rows.near(x, y, z); }); },
                 next);
}

} // namespace frostfill
