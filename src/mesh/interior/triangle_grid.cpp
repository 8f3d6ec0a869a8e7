// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_grid.hpp"

#include <algorithm>
#include <numeric>

namespace frostfill
{

TriangleGrid::TriangleGrid(const Surface& surface, const GridFrame& frame, double reach)
    : surface_(&surface), frame_(frame), reach_(reach), blocksFrame_(frame)
{
    blocksFrame_.cell *= kSide;
    for (int& count : blocksFrame_.count)
    {
        count = (count + kSide - 1) / kSide;
    }
    blocks_.assign(blocksFrame_.size(), kNoTriangles);
    // Count, sum up the ends of the cells, and fill each cell from its end.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // cell, triangle
    for (std::size_t t = 0; t < surface.size(); ++t)
    {
        forEachCellNear(frame_, surface[t], reach,
                        [&](int x, int y, int z)
                        {
                            std::uint32_t& block = blocks_[blockIndex(x, y, z)];
                            if (block == kNoTriangles)
                            {
                                block = static_cast<std::uint32_t>(starts_.size() / kInBlock);
                                starts_.resize(starts_.size() + kInBlock, 0);
                            }
                            const std::size_t cell = cellIndex(block, x, y, z);
                            ++starts_[cell];
                            pairs.emplace_back(static_cast<std::uint32_t>(cell),
                                               static_cast<std::uint32_t>(t));
                        });
    }
    starts_.push_back(0);
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    ids_.resize(pairs.size());
    std::for_each(pairs.rbegin(), pairs.rend(),
                  [this](const auto& pair) { ids_[--starts_[pair.first]] = pair.second; });
}

} // namespace frostfill
