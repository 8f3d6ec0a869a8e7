// SPDX-License-Identifier: MIT
#include "mesh/interior/edge_twins.hpp"

#include <array>

namespace frostfill
{

EdgeTwins::EdgeTwins(const EdgeTable& edges) : twins_(3 * edges.triangles(), kNone)
{
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2 && cancels(uses))
            {
                const std::array sides = {3 * uses[0].triangle + uses[0].corner,
                                          3 * uses[1].triangle + uses[1].corner};
                twins_[sides[0]] = sides[1];
                twins_[sides[1]] = sides[0];
            }
        });
}

bool EdgeTwins::isOneFan(const TriangleMesh& mesh, std::uint32_t vertex,
                         std::span<const std::uint32_t> triangles) const
{
    const std::uint32_t first = triangles[0];
    std::uint32_t triangle = first;
    std::size_t passed = 0;
    do
    {
        // The next triangle of the fan is across the side that ends at the vertex.
        const auto& t = mesh.triangles[triangle];
        const std::uint32_t before = t[0] == vertex ? 2 : (t[1] == vertex ? 0 : 1);
        const std::uint32_t twin = twins_[3 * triangle + before];
        if (twin == kNone)
        {
            return false;
        }
        triangle = twin / 3;
        ++passed;
    } while (triangle != first);
    return passed == triangles.size();
}

} // namespace frostfill
