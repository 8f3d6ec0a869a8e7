// SPDX-License-Identifier: MIT
#include "mesh/connectivity.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// Calls `visit(low, side)`, as EdgeTable packs it.
template <class Visit>
void forEachSide(const TriangleMesh& mesh, Visit&& visit)
{
    std::uint64_t side = 0;
    for (const Triangle& t : mesh.triangles)
    {
        if (repeatsCorner(t))
        {
            side += 3;
            continue;
        }
        for (std::size_t corner = 0; corner < 3; ++corner, ++side)
        {
            const auto [low, high] = std::minmax(t[corner], t[(corner + 1) % 3]);
            visit(low, std::uint64_t{high} << 32 | side << 1 | (low == t[corner] ? 1 : 0));
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

// In buckets by the lower vertex: most hold a few sides, which are soon sorted.
EdgeTable::EdgeTable(const TriangleMesh& mesh)
    : sides_(mesh.vertices.size(), [&](auto&& enter) { forEachSide(mesh, enter); })
{
    for (std::size_t low = 0; low < sides_.size(); ++low)
    {
        const std::span<Side> sides = sides_[low];
        std::sort(sides.begin(), sides.end());
    }
}

std::vector<EdgeUse> EdgeTable::find(std::uint32_t a, std::uint32_t b) const
{
    const auto [low, high] = std::minmax(a, b);
    const std::span<const Side> sides = sides_[low];
    std::vector<EdgeUse> uses;
    for (auto side = std::lower_bound(sides.begin(), sides.end(), Side{high} << 32);
         side != sides.end() && highOf(*side) == high; ++side)
    {
        uses.push_back(unpacked(low, *side));
    }
    return uses;
}

} // namespace frostfill
