// SPDX-License-Identifier: MIT
#include "mesh/repair/edge_table.hpp"

#include "mesh/repair/triangle_shape.hpp"

#include <algorithm>
#include <tuple>

namespace frostfill
{

EdgeTable::EdgeTable(const TriangleMesh& mesh)
{
    uses_.reserve(3 * mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        const Triangle& t = mesh.triangles[triangle];
        if (repeatsCorner(t))
        {
            continue;
        }
        for (std::uint8_t corner = 0; corner < 3; ++corner)
        {
            const auto [low, high] = std::minmax(t[corner], t[(corner + 1) % 3]);
            uses_.push_back(
                {low, high, static_cast<std::uint32_t>(triangle), corner, low == t[corner]});
        }
    }
    std::sort(uses_.begin(), uses_.end(),
              [](const EdgeUse& a, const EdgeUse& b) {
                  return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
              });
}

std::size_t EdgeTable::endOfEdge(std::size_t begin) const
{
    std::size_t end = begin + 1;
    while (end < uses_.size() && uses_[end].low == uses_[begin].low &&
           uses_[end].high == uses_[begin].high)
    {
        ++end;
    }
    return end;
}

std::span<const EdgeUse> EdgeTable::find(std::uint32_t a, std::uint32_t b) const
{
    const auto [low, high] = std::minmax(a, b);
    const auto first = std::lower_bound(uses_.begin(), uses_.end(), std::pair(low, high),
                                        [](const EdgeUse& use, const auto& edge)
                                        { return std::pair(use.low, use.high) < edge; });
    if (first == uses_.end() || first->low != low || first->high != high)
    {
        return {};
    }
    const auto begin = static_cast<std::size_t>(first - uses_.begin());
    return {uses_.data() + begin, endOfEdge(begin) - begin};
}

std::size_t EdgeTable::badEdges() const
{
    std::size_t count = 0;
    forEach([&](std::span<const EdgeUse> uses) { count += uses.size() != 2 ? 1U : 0U; });
    return count;
}

} // namespace frostfill
