// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_tree.hpp"

#include <frostfill/mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// A bounding volume hierarchy of the triangles of a mesh, four children a node [Wald et al. 2008].
/// Boxes are in single precision, in a frame in which the mesh is as large as 1. They grow by
/// rounding, so nothing near enough is left out: who visits it and judges the triangles by itself
/// gets what a list of all triangles would give.
class TriangleBvh
{
public:
    explicit TriangleBvh(const TriangleMesh& mesh);
    /// With the tree that halves its triangles, of leaves of kSmallLeaf: that of this mesh, or of
    /// one that differs by a motion and a scale.
    TriangleBvh(const TriangleMesh& mesh, const TriangleTree& tree);

    /// Calls `limit = visit(triangles)` with the triangles of each leaf whose box may be within
    /// `limit` of a box, a distance [unit]; what seems nearest first.
    template <class Visit>
    void forEachNear(const Eigen::AlignedBox3d& box, double limit, Visit&& visit) const;

    /// The triangles whose leaf's box comes within `distance` of p, ascending, in place of what
    /// `found` had.
    void findNear(const Eigen::Vector3d& p, double distance,
                  std::vector<std::uint32_t>& found) const;

    /// All triangles, so that those side by side lie near each other.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

private:
    static constexpr std::size_t kWidth = 4;     // children
    static constexpr std::size_t kDeepest = 128; // pending children: 3 a level, 2^32 triangles
    /// By which coordinates and squared distances may be wrong, twofold. [1]
    static constexpr double kGrow = 0x1p-23;
    static constexpr double kRounding = 0x1p-20;

    struct Child
    {
        std::uint32_t first = 0;     ///< node, or place in order_
        std::uint32_t triangles = 0; ///< 0: a node
    };
    using Four = float __attribute__((vector_size(4 * kWidth))); // registers of all processors
    struct Node
    {
        std::array<Four, 3> low; ///< infinite where there is no child
        std::array<Four, 3> high;
        std::array<Child, kWidth> child;
    };
    struct Pending
    {
        float square;
        Child child;
    };
    /// Along each axis, in the frame of the nodes.
    struct Box
    {
        std::array<float, 3> low, high;
    };

    /// That contains `box` for certain.
    [[nodiscard]] Box around(const Eigen::AlignedBox3d& box) const;
    [[nodiscard]] static Four squaresTo(const Node& node, const Box& box);
    /// Of a distance of the mesh. Finite, so that what is not there is beyond it.
    [[nodiscard]] float squareOf(double limit) const
    {
        const double square = limit * scale_ * limit * scale_ * (1 + kRounding);
        return static_cast<float>(std::min<double>(square, std::numeric_limits<float>::max()));
    }

    class Builder;

    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(); ///< of the mesh
    double scale_ = 1;                                 ///< by which it has the size 1
    std::vector<Node> nodes_;                          ///< the first is the root
    std::vector<std::uint32_t> order_;
};

inline TriangleBvh::Box TriangleBvh::around(const Eigen::AlignedBox3d& box) const
{
    Box result{};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
        const double low = (box.min()[axis] - centre_[axis]) * scale_;
        const double high = (box.max()[axis] - centre_[axis]) * scale_;
        const auto at = static_cast<std::size_t>(axis);
        result.low[at] = static_cast<float>(low - kGrow * (1 + std::abs(low)));
        result.high[at] = static_cast<float>(high + kGrow * (1 + std::abs(high)));
    }
    return result;
}

inline TriangleBvh::Four TriangleBvh::squaresTo(const Node& node, const Box& box)
{
    Four squares{};
    constexpr Four kNone = {};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const Four below = node.low[axis] - box.high[axis];
        const Four above = box.low[axis] - node.high[axis];
        const Four apart = below > above ? below : above;
        const Four outside = apart > kNone ? apart : kNone;
        squares += outside * outside;
    }
    return squares;
}

template <class Visit>
void TriangleBvh::forEachNear(const Eigen::AlignedBox3d& box, double limit, Visit&& visit) const
{
    std::array<Pending, kDeepest> pending;
    std::size_t count = 0;
    const Box from = around(box);
    float square = squareOf(limit);
    if (!nodes_.empty())
    {
        pending[count++] = {0, {0, 0}};
    }
    while (count > 0)
    {
        const Pending next = pending[--count];
        if (next.square > square)
        {
            continue;
        }
        if (next.child.triangles > 0)
        {
            square =
                squareOf(visit(std::span(order_).subspan(next.child.first, next.child.triangles)));
            continue;
        }
        const Node& node = nodes_[next.child.first];
        const Four squares = squaresTo(node, from);
        const std::size_t begin = count;
        for (std::size_t k = 0; k < kWidth; ++k)
        {
            if (squares[k] <= square)
            {
                // Sorted as they come: the nearest is the last, which is taken first.
                std::size_t place = count++;
                for (; place > begin && pending[place - 1].square < squares[k]; --place)
                {
                    pending[place] = pending[place - 1];
                }
                pending[place] = {squares[k], node.child[k]};
            }
        }
    }
}

} // namespace frostfill
