// SPDX-License-Identifier: MIT
#include <mesh/triangle_grid.hpp>

#include <algorithm>
#include <numeric>

namespace frostfill
{

TriangleGrid::TriangleGrid(const Surface& surface, const GridFrame& frame, double reach)
    : frame_(frame), reach_(reach), start_(frame.size() + 1, 0)
{
    // Count, sum up to where each cell ends, and fill each from its end.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // cell, triangle
    for (std::size_t t = 0; t < surface.size(); ++t)
    {
        forEachCellNear(frame_, surface[t], reach,
                        [&](int x, int y, int z)
                        {
                            const std::size_t cell = frame_.index(x, y, z);
                            ++start_[cell];
                            pairs.emplace_back(static_cast<std::uint32_t>(cell),
                                               static_cast<std::uint32_t>(t));
                        });
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    ids_.resize(pairs.size());
    std::for_each(pairs.rbegin(), pairs.rend(),
                  [this](const auto& pair) { ids_[--start_[pair.first]] = pair.second; });
}

} // namespace frostfill
