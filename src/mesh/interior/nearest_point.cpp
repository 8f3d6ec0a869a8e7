// SPDX-License-Identifier: MIT
#include "mesh/interior/nearest_point.hpp"

#include "geometry/closest_point.hpp"

#include <array>
#include <utility>

namespace frostfill
{
namespace
{

constexpr std::uint32_t kTrianglesPerLeaf = 4;

} // namespace

NearestPoint::NearestPoint(const TriangleMesh& mesh)
    : mesh_(&mesh), tree_(mesh, kTrianglesPerLeaf), boxes_(tree_.nodes().size())
{
    // Nodes are in preorder: what is below a node is known when the walk back comes to it.
    for (std::size_t i = boxes_.size(); i-- > 0;)
    {
        if (!tree_.isLeaf(i))
        {
            const std::size_t second = tree_.nodes()[i + 1].skip;
            boxes_[i] = boxes_[i + 1].merged(boxes_[second]);
            continue;
        }
        for (const std::uint32_t triangle : tree_.triangles(tree_.nodes()[i]))
        {
            for (const std::uint32_t corner : mesh.triangles[triangle])
            {
                boxes_[i].extend(mesh.vertices[corner]);
            }
        }
    }
}

std::optional<Eigen::Vector3d> NearestPoint::find(const Eigen::Vector3d& p, double within) const
{
    Found found{within * within, std::nullopt};
    if (!boxes_.empty() && boxes_[0].squaredExteriorDistance(p) < found.square)
    {
        searchNode(0, p, found);
    }
    return found.point;
}

// The nearer child first: the other one is then mostly too far away.
void NearestPoint::searchNode(std::size_t node, const Eigen::Vector3d& p, Found& found) const
{
    if (tree_.isLeaf(node))
    {
        for (const std::uint32_t triangle : tree_.triangles(tree_.nodes()[node]))
        {
            const auto& [a, b, c] = mesh_->triangles[triangle];
            const Eigen::Vector3d point =
                closestPointOnTriangle(p, mesh_->vertices[a], mesh_->vertices[b],
                                       mesh_->vertices[c])
                    .point;
            const double square = (point - p).squaredNorm();
            if (square < found.square)
            {
                found = {square, point};
            }
        }
        return;
    }
    std::array<std::size_t, 2> child = {node + 1, tree_.nodes()[node + 1].skip};
    std::array<double, 2> square = {boxes_[child[0]].squaredExteriorDistance(p),
                                    boxes_[child[1]].squaredExteriorDistance(p)};
    if (square[1] < square[0])
    {
        std::swap(child[0], child[1]);
        std::swap(square[0], square[1]);
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
        if (square[k] < found.square)
        {
            searchNode(child[k], p, found);
        }
    }
}

} // namespace frostfill
