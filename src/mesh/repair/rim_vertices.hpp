// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"
#include "mesh/interior/triangle_tree.hpp"

namespace frostfill
{

/// The vertices of rims in a tree of boxes.
class RimVertices
{
public:
    RimVertices(const TriangleMesh& mesh, const EdgeTable& edges);

    /// Calls `visit(vertex)` for all that are closer than `distance` to the segment, and others.
    template <typename Visit>
    void near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double distance,
              Visit&& visit) const
    {
        for (std::size_t node = 0; node < boxes_.size();)
        {
            if (!mayTouch(boxes_[node], a, b, distance))
            {
                node = tree_.nodes()[node].skip;
                continue;
            }
            if (tree_.isLeaf(node))
            {
                for (const std::uint32_t point : tree_.triangles(tree_.nodes()[node]))
                {
                    visit(points_.triangles[point][0]);
                }
            }
            ++node;
        }
    }

private:
    [[nodiscard]] static bool mayTouch(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, double distance);

    TriangleMesh points_; ///< a triangle for each vertex, with no other corner
    TriangleTree tree_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#nodes]
};

} // namespace frostfill
