// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// A bounding volume hierarchy of the triangles of a mesh, four children a node [Wald et al. 2008].
/// Boxes grow by rounding, so nothing near enough is left out: who visits it and judges the
/// triangles by itself gets what a list of all triangles would give.
class TriangleBvh
{
public:
    explicit TriangleBvh(const TriangleMesh& mesh);

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
    static constexpr std::uint32_t kLeaf = 4;    // triangles at most
    static constexpr std::size_t kDeepest = 128; // pending children: 3 a level, 2^32 triangles
    /// By which squared distances may be wrong, tenfold. [1]
    static constexpr double kRounding = 1e-14;

    struct Child
    {
        std::uint32_t first = 0;     ///< node, or place in order_
        std::uint32_t triangles = 0; ///< 0: a node
    };
    struct Node
    {
        std::array<std::array<double, kWidth>, 3> low; ///< infinite where there is no child
        std::array<std::array<double, kWidth>, 3> high;
        std::array<Child, kWidth> child;
    };
    struct Pending
    {
        double square;
        Child child;
    };

    using Squares = std::array<double, kWidth>;
    [[nodiscard]] static Squares squaresTo(const Node& node, const Eigen::AlignedBox3d& box);
    /// Finite, so that what is not there is beyond it.
    [[nodiscard]] static double squareOf(double limit)
    {
        return std::min(limit * limit * (1 + kRounding), std::numeric_limits<double>::max());
    }

    class Builder;

    std::vector<Node> nodes_; ///< the first is the root
    std::vector<std::uint32_t> order_;
};

inline TriangleBvh::Squares TriangleBvh::squaresTo(const Node& node, const Eigen::AlignedBox3d& box)
{
    Squares squares{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double low = box.min()[static_cast<Eigen::Index>(axis)];
        const double high = box.max()[static_cast<Eigen::Index>(axis)];
        for (std::size_t k = 0; k < kWidth; ++k)
        {
            const double below = node.low[axis][k] - high;
            const double above = low - node.high[axis][k];
            const double apart = below > above ? below : above;
            squares[k] += apart > 0 ? apart * apart : 0;
        }
    }
    return squares;
}

template <class Visit>
void TriangleBvh::forEachNear(const Eigen::AlignedBox3d& box, double limit, Visit&& visit) const
{
    std::array<Pending, kDeepest> pending;
    std::size_t count = 0;
    double square = squareOf(limit);
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
        const Squares squares = squaresTo(node, box);
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
