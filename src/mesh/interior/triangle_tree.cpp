// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace frostfill
{

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize)
    : order_(mesh.triangles.size())
{
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    std::vector<Eigen::Vector3d> centroids;
    centroids.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
    {
        centroids.emplace_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) /
                               3);
    }
    if (!order_.empty())
    {
        split(centroids, 0, static_cast<std::uint32_t>(order_.size()), leafSize);
    }
}

// Each call halves its triangles, so a million of them take 20 nested calls, however they lie.
void TriangleTree::split(std::span<const Eigen::Vector3d> centroids, std::uint32_t first,
                         std::uint32_t end, std::uint32_t leafSize)
{
    const std::size_t node = nodes_.size();
    nodes_.push_back({first, end, 0});
    const auto begin = order_.begin() + first;
    if (end - first <= leafSize)
    {
        std::sort(begin, order_.begin() + end);
    }
    else
    {
        Eigen::AlignedBox3d box;
        std::for_each(begin, order_.begin() + end,
                      [&](std::uint32_t triangle) { box.extend(centroids[triangle]); });
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const std::uint32_t middle = first + (end - first) / 2;
        // Equal centroids are told apart by their number, so the halves depend on no library.
        std::nth_element(
            begin, order_.begin() + middle, order_.begin() + end,
            [&](std::uint32_t a, std::uint32_t b)
            { return std::pair(centroids[a][axis], a) < std::pair(centroids[b][axis], b); });
        split(centroids, first, middle, leafSize);
        split(centroids, middle, end, leafSize);
    }
    nodes_[node].skip = static_cast<std::uint32_t>(nodes_.size());
}

} // namespace frostfill
