// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"

#include "mesh/interior/triangle_bound.hpp"
#include "mesh/interior/triangle_tree.hpp"

namespace frostfill
{

/// Takes every second level of the binary tree.
class TriangleBvh::Builder
{
public:
    Builder(const TriangleMesh& mesh, const TriangleTree& tree, TriangleBvh& bvh)
        : mesh_(mesh), tree_(tree), bvh_(bvh), boxes_(tree.nodes().size())
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
            built.child[count++] = tree_.isLeaf(below) ? Child{addLeaf(its), its.end - its.first}
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
    /// Leaves come in the order of their triangles.
    std::uint32_t addLeaf(const TriangleTree::Node& its)
    {
        Leaf leaf{};
        for (std::size_t k = 0; k < its.end - its.first; ++k)
        {
            const auto& t = mesh_.triangles[tree_.order()[its.first + k]];
            const auto [normal, offset, centre, radius] =
                boundOf({mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]});
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                const auto at = static_cast<Eigen::Index>(axis);
                leaf.normal[axis][k] = static_cast<float>(normal[at]);
                leaf.centre[axis][k] =
                    static_cast<float>((centre[at] - bvh_.centre_[at]) * bvh_.scale_);
            }
            leaf.offset[k] = static_cast<float>((offset - normal.dot(bvh_.centre_)) * bvh_.scale_);
            leaf.radius[k] = static_cast<float>(radius * bvh_.scale_ * (1 + kRounding) + kGrow);
        }
        bvh_.leaves_.push_back(leaf);
        bvh_.starts_.push_back(its.end);
        return static_cast<std::uint32_t>(bvh_.leaves_.size() - 1);
    }

    [[nodiscard]] std::size_t second(std::size_t node) const
    {
        return tree_.nodes()[node + 1].skip;
    }

    const TriangleMesh& mesh_;
    const TriangleTree& tree_;
    TriangleBvh& bvh_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#nodes of tree_]
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh)
{
    if (mesh.triangles.empty())
    {
        return;
    }
    const TriangleTree tree(mesh, kLeaf);
    order_.assign(tree.order().begin(), tree.order().end());
    starts_.push_back(0);
    Builder(mesh, tree, *this).build(0);
}

void TriangleBvh::findNear(const Eigen::Vector3d& p, double distance,
                           std::vector<std::uint32_t>& found) const
{
    found.clear();
    forEachTriangleNear(p, distance,
                        [&](std::uint32_t triangle)
                        {
                            found.push_back(triangle);
                            return distance;
                        });
    std::sort(found.begin(), found.end());
}

// Level by level, as long as they are few. A node with a leaf below it stays.
void TriangleBvh::findNodes(const Eigen::Vector3d& p, double distance, Nodes& nodes) const
{
    nodes.assign(kRoot.begin(), kRoot.end());
    const Box from = around(Eigen::AlignedBox3d(p));
    const float square = squareOf(distance);
    for (std::size_t k = 0; !nodes_.empty() && k < nodes.size();)
    {
        const Node& node = nodes_[nodes[k]];
        const Four squares = squaresTo(node, from);
        std::array<std::uint32_t, kWidth> below{};
        std::size_t count = 0;
        bool leaf = false;
        for (std::size_t child = 0; child < kWidth; ++child)
        {
            if (squares[child] <= square)
            {
                leaf = leaf || node.child[child].triangles > 0;
                below[count++] = node.child[child].number;
            }
        }
        if (leaf || nodes.size() - 1 + count > kMostNodes)
        {
            ++k;
            continue;
        }
        nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(k));
        nodes.insert(nodes.end(), below.begin(),
                     below.begin() + static_cast<std::ptrdiff_t>(count));
    }
}

} // namespace frostfill
