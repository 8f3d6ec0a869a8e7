// SPDX-License-Identifier: MIT
#include "mesh/edge_table.hpp"

#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace frostfill
{
namespace
{

template <class Visit>
void forEachSide(const TriangleMesh& mesh, Visit&& visit)
{
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
            visit(
                EdgeUse{low, high, static_cast<std::uint32_t>(triangle), corner, low == t[corner]});
        }
    }
}

} // namespace

bool cancels(std::span<const EdgeUse> uses)
{
    const auto forward =
        std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.forward; });
    return 2 * static_cast<std::size_t>(forward) == uses.size();
}

EdgeTable::EdgeTable(const TriangleMesh& mesh)
{
    // In buckets by the lower vertex: most hold a few sides, which are soon sorted.
    std::vector<std::size_t> ends(mesh.vertices.size() + 1, 0);
    forEachSide(mesh, [&](const EdgeUse& use) { ++ends[use.low + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    uses_.resize(ends.back());
    forEachSide(mesh, [&](const EdgeUse& use) { uses_[ends[use.low]++] = use; });
    auto begin = uses_.begin();
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    {
        const auto end = uses_.begin() + static_cast<std::ptrdiff_t>(ends[vertex]);
        std::sort(begin, end,
                  [](const EdgeUse& a, const EdgeUse& b)
                  { return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle); });
        begin = end;
    }
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
