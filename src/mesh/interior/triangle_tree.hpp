// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"

#include <frostfill/mesh.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Triangles in a leaf of trees whose visitors look at each of them.
inline constexpr std::uint32_t kSmallLeaf = 4;

/// A balanced binary tree of the triangles of a mesh, halved at the median centroid along the
/// longest side. Nodes are in preorder: the first child of a node follows it. A walk needs no
/// stack: it continues with the next node, or with `skip` to leave out what is below.
class TriangleTree
{
public:
    struct Node
    {
        std::uint32_t first = 0; ///< place in order()
        std::uint32_t end = 0;   ///< place in order()
        std::uint32_t skip = 0;  ///< node after the last one below this one
    };

    /// A leaf has at most `leafSize` triangles and at least half as many (all, if the mesh has
    /// fewer).
    TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize, Threads& threads);
    TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize);

    /// Gives its memory back, once nothing asks it any more.
    void clear()
    {
        nodes_ = std::vector<Node>();
        order_ = std::vector<std::uint32_t>();
    }

    [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
    [[nodiscard]] bool isLeaf(std::size_t node) const { return nodes_[node].skip == node + 1; }

    /// [#T] triangles; those of a node are neighbours in it, ascending within a leaf.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
    [[nodiscard]] std::span<const std::uint32_t> triangles(const Node& node) const
    {
        return {order_.data() + node.first, node.end - node.first};
    }

private:
    struct Item
    {
        Eigen::Vector3d centroid;
        std::uint32_t triangle;
    };

    /// What is below a node: as many nodes as its items need, whatever they are, so each knows its
    /// place before those in front of it are there.
    struct Part
    {
        std::span<Item> items;
        std::uint32_t first; ///< place of the first item in order()
        std::uint32_t node;
    };

    void build(const Part& root, std::uint32_t leafSize, Threads& threads);
    void split(const Part& part, std::uint32_t leafSize);
    [[nodiscard]] std::array<Part, 2> halve(const Part& part, std::uint32_t leafSize);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace frostfill
