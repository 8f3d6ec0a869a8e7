// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"

#include "mesh/interior/triangle_bound.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{

/// Takes every second level of the binary tree, so that the last one has the leaves.
class TriangleBvh::Builder
{
public:
    /// Triangles below a child that has a disc. Larger: more time to build. Smaller: more boxes are
    /// looked into near a slanted wall.
    static constexpr std::uint32_t kMostInDisc = 64;

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
        Node built{};
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
                built.low[axis][count] = box.low[axis][0];
                built.high[axis][count] = box.high[axis][0];
            }
            const TriangleTree::Node& its = tree_.nodes()[below];
            enterDisc(built, count, its);
            built.child[count++] = tree_.isLeaf(below) ? Child{addLeaf(its), its.end - its.first}
                                                       : Child{build(below), 0};
        };
        forEachChild(node, take);
        bvh_.nodes_[number] = built;
        return number;
    }

    /// Room for all that `build` adds: arrays that grow are half empty, and for a while there
    /// twice.
    void reserve()
    {
        const std::size_t leaves = (boxes_.size() + 1) / 2;
        bvh_.leaves_.reserve(leaves);
        bvh_.starts_.reserve(leaves + 1);
        bvh_.nodes_.reserve(nodesFrom(0));
    }

private:
    /// Calls `visit` with the nodes of the binary tree that become the children of one.
    template <typename Visit>
    void forEachChild(std::size_t node, Visit&& visit) const
    {
        if (tree_.isLeaf(node))
        {
            visit(node);
            return;
        }
        const bool oneLevel = node == 0 && levels() % 2 == 1;
        for (const std::size_t half : {node + 1, second(node)})
        {
            if (oneLevel || tree_.isLeaf(half))
            {
                visit(half);
                continue;
            }
            visit(half + 1);
            visit(second(half));
        }
    }

    /// This one and those below it, of those that `build` makes.
    [[nodiscard]] std::size_t nodesFrom(std::size_t node) const
    {
        std::size_t count = 1;
        forEachChild(node, [&](std::size_t below)
                     { count += tree_.isLeaf(below) ? 0 : nodesFrom(below); });
        return count;
    }

    /// From the root to the first leaf; to others they differ by one at most.
    [[nodiscard]] std::size_t levels() const
    {
        std::size_t node = 0;
        while (!tree_.isLeaf(node))
        {
            ++node; // its first child
        }
        return node;
    }

    /// Leaves come in the order of their triangles.
    std::uint32_t addLeaf(const TriangleTree::Node& its)
    {
        Discs discs{};
        for (std::size_t k = 0; k < its.end - its.first; ++k)
        {
            enter(discs, k, boundOf(cornersOf(mesh_, tree_.order()[its.first + k])));
        }
        bvh_.leaves_.push_back(discs);
        bvh_.starts_.push_back(its.end);
        return static_cast<std::uint32_t>(bvh_.leaves_.size() - 1);
    }

    /// Makes a disc the k-th, in the frame of the nodes.
    void enter(Discs& discs, std::size_t k, const TriangleBound& disc) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const auto at = static_cast<Eigen::Index>(axis);
            discs.normal[axis][k] = static_cast<float>(disc.normal[at]);
            discs.centre[axis][k] =
                static_cast<float>((disc.centre[at] - bvh_.centre_[at]) * bvh_.scale_);
        }
        discs.offset[k] =
            static_cast<float>((disc.offset - disc.normal.dot(bvh_.centre_)) * bvh_.scale_);
        discs.radius[k] = grown(disc.radius);
    }
    [[nodiscard]] float grown(double length) const
    {
        return static_cast<float>(length * bvh_.scale_ * (1 + kRounding) + kGrow);
    }

    /// The disc, with its thickness, around all triangles of a node.
    void enterDisc(Node& built, std::size_t k, const TriangleTree::Node& its) const
    {
        if (its.end - its.first > kMostInDisc)
        {
            built.discs.radius[k] = static_cast<float>(kFarthest);
            return;
        }
        built.hasDiscs = true;
        TriangleBound disc;
        disc.normal.setZero();
        disc.centre.setZero();
        const auto forEach = [&](auto&& visit)
        {
            for (const std::uint32_t triangle : tree_.triangles(its))
            {
                visit(cornersOf(mesh_, triangle));
            }
        };
        forEach(
            [&](const std::array<Eigen::Vector3d, 3>& corner)
            {
                const auto& [a, b, c] = corner;
                disc.normal += (c - a).cross(b - a);
                disc.centre += (a + b + c) / 3;
            });
        disc.normal.normalize();
        disc.centre /= its.end - its.first;
        disc.offset = disc.normal.dot(disc.centre);
        double thickness = 0;
        forEach(
            [&](const std::array<Eigen::Vector3d, 3>& corner)
            {
                for (const Eigen::Vector3d& p : corner)
                {
                    disc.radius = std::max(disc.radius, (p - disc.centre).norm());
                    thickness = std::max(thickness, disc.toPlane(p));
                }
            });
        enter(built.discs, k, disc);
        built.thickness[k] = grown(thickness);
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
    starts_.push_back(0);
    Builder builder(mesh, tree, *this);
    builder.reserve();
    builder.build(0);
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
