// SPDX-License-Identifier: MIT
#include "mesh/interior/inside_test.hpp"
#include "mesh/interior/near_surface.hpp"

#include <algorithm>

/// Where the nearest triangle does not tell the side.
namespace frostfill
{

void InsideTest::markTwoSided()
{
    const TriangleGrid::Cells& cells = grid_->cells();
    hasTwoSided_.assign(cells.size(), false);
    for (std::uint32_t triangle = 0; triangle < surface_->size(); ++triangle)
    {
        if ((*surface_)[triangle].twoSided)
        {
            forEachRunNear(grid_->frame(), *surface_, {{&triangle, 1}, {}}, grid_->reachOfCentre(),
                           [&](int y, int z, CellRun run, auto&& isNear)
                           {
                               for (int x = run.first; x <= run.last; ++x)
                               {
                                   const std::size_t cell = cells.find(x, y, z);
                                   if (cell != TriangleGrid::Cells::kNone && isNear(x))
                                   {
                                       hasTwoSided_[cell] = true;
                                   }
                               }
                           });
        }
    }
}

bool InsideTest::isNearTwoSided(const Eigen::Vector3d& p) const
{
    const auto isTwoSided = [this](std::uint32_t id) { return (*surface_)[id].twoSided; };
    const auto [x, y, z] = grid_->frame().coordinates(p);
    const std::size_t cell = grid_->cells().find(x, y, z);
    if (hasTwoSided_.empty() || !hasTwoSided_[cell])
    {
        return false;
    }
    const std::span<const std::uint32_t> all = grid_->ofCell(cell);
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
