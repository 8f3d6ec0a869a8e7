// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_tree.hpp"

#include <algorithm>
#include <cstddef>

namespace frostfill
{

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize)
{
    std::vector<Item> items;
    items.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d centroid =
            (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
        items.push_back({centroid, static_cast<std::uint32_t>(items.size())});
    }
    if (!items.empty())
    {
        split(items, 0, leafSize);
    }
    order_.reserve(items.size());
    for (const Item& item : items)
    {
        order_.push_back(item.triangle);
    }
}

// Each call halves its triangles, so a million of them take 20 nested calls, however they lie.
void TriangleTree::split(std::span<Item> items, std::uint32_t first, std::uint32_t leafSize)
{
    const std::size_t node = nodes_.size();
    nodes_.push_back({first, first + static_cast<std::uint32_t>(items.size()), 0});
    if (items.size() <= leafSize)
    {
        std::sort(items.begin(), items.end(),
                  [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
    }
    else
    {
        Eigen::AlignedBox3d box;
        std::for_each(items.begin(), items.end(),
                      [&](const Item& item) { box.extend(item.centroid); });
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const std::size_t middle = items.size() / 2;
        // Equal centroids are told apart by their number, so the halves depend on no library.
        std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                         items.end(),
                         [axis](const Item& a, const Item& b)
                         {
                             const double one = a.centroid[axis];
                             const double other = b.centroid[axis];
                             return one < other || (one == other && a.triangle < b.triangle);
                         });
        split(items.first(middle), first, leafSize);
        split(items.subspan(middle), first + static_cast<std::uint32_t>(middle), leafSize);
    }
    nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
}

} // namespace frostfill
