// SPDX-License-Identifier: MIT
#include <mesh/triangle_grid.hpp>

namespace frostfill
{

TriangleGrid::TriangleGrid(const Surface& surface, const GridFrame& frame, double reach)
    : frame_(frame), reach_(reach), start_(frame.size() + 1, 0)
{
    // Count, prefix sum, scatter.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // cell, triangle
    for (std::size_t t = 0; t < surface.size(); ++t)
    {
        forEachCellNear(frame_, surface[t], reach,
                        [&](int x, int y, int z)
                        {
                            const std::size_t cell = frame_.index(x, y, z);
                            ++start_[cell + 1];
                            pairs.emplace_back(static_cast<std::uint32_t>(cell),
                                               static_cast<std::uint32_t>(t));
                        });
    }
    for (std::size_t cell = 1; cell < start_.size(); ++cell)
    {
        start_[cell] += start_[cell - 1];
    }
    ids_.resize(pairs.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (const auto& [cell, triangle] : pairs)
    {
        ids_[next[cell]++] = triangle;
    }
}

} // namespace frostfill
