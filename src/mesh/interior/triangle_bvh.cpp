// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"

namespace frostfill
{

/// Takes every second level of the binary tree.
class TriangleBvh::Builder
{
public:
    Builder(const TriangleMesh& mesh, const TriangleTree& tree, TriangleBvh& bvh)
        : tree_(tree), bvh_(bvh), boxes_(tree.nodes().size())
    {
        // What is below a node stands behind it.
        for (std::size_t node = boxes_.size(); node-- > 0;)
        {
            if (!tree.isLeaf(node))
            {
                boxes_[node] = boxes_[node + 1].merged(boxes_[second(node)]);
                continue;
            }
            for (const std::uint32_t triangle : tree.triangles(tree.nodes()[node]))
            {
                for (const std::uint32_t corner : mesh.triangles[triangle])
                {
                    boxes_[node].extend(mesh.vertices[corner]);
                }
            }
        }
        const double size = boxes_[0].sizes().maxCoeff();
        bvh_.centre_ = boxes_[0].center();
        bvh_.scale_ = size > 0 ? 1 / size : 1;
    }

    /// Returns the node's number among those of four.
    std::uint32_t build(std::size_t node)
    {
        const auto number = static_cast<std::uint32_t>(bvh_.nodes_.size());
        bvh_.nodes_.emplace_back(); // and its children behind it, which may move it
        Node built;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            built.low[axis] = Four{} + std::numeric_limits<float>::infinity();
            built.high[axis] = Four{} - std::numeric_limits<float>::infinity();
        }
        std::size_t count = 0;
        const auto take = [&](std::size_t below)
        {
            const Box box = bvh_.around(boxes_[below]);
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                built.low[axis][count] = box.low[axis];
                built.high[axis][count] = box.high[axis];
            }
            const TriangleTree::Node& its = tree_.nodes()[below];
            built.child[count++] = tree_.isLeaf(below) ? Child{its.first, its.end - its.first}
                                                       : Child{build(below), 0};
        };
        if (tree_.isLeaf(node))
        {
            take(node);
        }
        else
        {
            for (const std::size_t half : {node + 1, second(node)})
            {
                if (tree_.isLeaf(half))
                {
                    take(half);
                    continue;
                }
                take(half + 1);
                take(second(half));
            }
        }
        bvh_.nodes_[number] = built;
        return number;
    }

private:
    [[nodiscard]] std::size_t second(std::size_t node) const
    {
        return tree_.nodes()[node + 1].skip;
    }

    const TriangleTree& tree_;
    TriangleBvh& bvh_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#nodes of tree_]
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh)
    : TriangleBvh(mesh, TriangleTree(mesh, kSmallLeaf))
{
}

TriangleBvh::TriangleBvh(const TriangleMesh& mesh, const TriangleTree& tree)
{
    if (mesh.triangles.empty())
    {
        return;
    }
    order_.assign(tree.order().begin(), tree.order().end());
    Builder(mesh, tree, *this).build(0);
}

void TriangleBvh::findNear(const Eigen::Vector3d& p, double distance,
                           std::vector<std::uint32_t>& found) const
{
    found.clear();
    forEachNear(Eigen::AlignedBox3d(p), distance,
                [&](std::span<const std::uint32_t> triangles)
                {
                    found.insert(found.end(), triangles.begin(), triangles.end());
                    return distance;
                });
    std::sort(found.begin(), found.end());
}

} // namespace frostfill
