// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"

#include <frostfill/mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Four planes, and discs in them, as TriangleBound has them for one triangle, tested at once in
/// single precision. All lengths are in a frame in which the mesh is as large as 1.
struct FourDiscs
{
    static constexpr unsigned kFour = 4;
    using Four = float __attribute__((vector_size(4 * kFour))); // registers of all processors
    /// By which a squared distance may be wrong, twofold. [1]
    static constexpr double kRounding = 0x1p-20;

    /// A place, four times over, and by how much rounding may be wrong there.
    struct Point
    {
        std::array<Four, 3> at;
        float rounding;
    };
    /// A straight way: its middle, and what it goes to either side of it.
    struct Way
    {
        Point middle;
        std::array<Four, 3> half;
        float reach; ///< around the way
        float ball;  ///< around its middle
    };

    /// A bit for each disc of that thickness, to either side, set where some of it may be within a
    /// distance of a point.
    [[nodiscard]] unsigned mayBeWithin(const Four& thickness, const Point& point,
                                       float distance) const;
    /// The same, within the reach of a way.
    [[nodiscard]] unsigned mayBeOnWay(const Four& thickness, const Way& way) const;

    using Mask = decltype(Four{} < Four{});
    /// A bit for each that holds.
    [[nodiscard]] static unsigned bitsOf(const Mask& mask)
    {
#if defined(__SSE__)
        return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Four>(mask)));
#else
        unsigned bits = 0;
        for (unsigned k = 0; k < kFour; ++k)
        {
            bits |= mask[k] != 0 ? 1U << k : 0U;
        }
        return bits;
#endif
    }
    [[nodiscard]] static Four fourTimes(float value)
    {
        return Four{} + value;
    }

    std::array<Four, 3> normal;
    Four offset;
    std::array<Four, 3> centre;
    Four radius;
};

// The test of TriangleBound, where what is subtracted is made smaller and what is added larger by
// more than rounding. The distance has been grown by what the place may be wrong.
inline unsigned FourDiscs::mayBeWithin(const Four& thickness, const Point& point,
                                       float distance) const
{
    constexpr auto kLess = static_cast<float>(1 - kRounding);
    constexpr Four kNone = {};
    Four toPlane = -offset;
    Four toCentre{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        toPlane += normal[axis] * point.at[axis];
        const Four apart = centre[axis] - point.at[axis];
        toCentre += apart * apart;
    }
    const Four behind = -toPlane;
    const Four height = toPlane > behind ? toPlane : behind;
    const Four above = height - (thickness + point.rounding);
    const Four least = above > kNone ? above : kNone;
    const Four most = height + point.rounding;
    // In a plane through the nearest of it, the ball around the point is a disc of this radius.
    const Four cut = distance * distance - least * least;
    const Four rest = toCentre * kLess - (most * most + radius * radius + cut);
    const Mask within =
        (cut >= kNone) & ((rest <= kNone) | (rest * rest <= 4.0F * radius * radius * cut));
    return bitsOf(within);
}

// All of the way is at least as far from a plane as its middle, less what it goes towards it.
inline unsigned FourDiscs::mayBeOnWay(const Four& thickness, const Way& way) const
{
    Four toPlane = -offset;
    Four across{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        toPlane += normal[axis] * way.middle.at[axis];
        across += normal[axis] * way.half[axis];
    }
    const Four behind = -toPlane;
    const Four back = -across;
    const Four height = toPlane > behind ? toPlane : behind;
    const Mask within = height <= (across > back ? across : back) +
                                      (thickness + (way.reach + 2 * way.middle.rounding));
    return bitsOf(within) & mayBeWithin(thickness, way.middle, way.ball);
}

/// A bounding volume hierarchy of the triangles of a mesh, four children a node [Wald et al. 2008],
/// four triangles a leaf. Boxes, planes and discs are in single precision, in a frame in which the
/// mesh is as large as 1, and four of them are tested at once. They grow by rounding, so nothing
/// near enough is left out: who visits it and judges the triangles by itself gets what a list of
/// all triangles would give.
///
/// A box beside a slanted wall is nearer than what is in it. Of small nodes of a fine mesh that
/// come near by their boxes, the number grows with its fineness; by discs with a thickness, which
/// small nodes have besides, few do.
class TriangleBvh
{
public:
    TriangleBvh() = default; ///< of no triangles
    explicit TriangleBvh(const TriangleMesh& mesh);
    /// The same, made by several threads.
    TriangleBvh(const TriangleMesh& mesh, Threads& threads);

    /// Makes it that of the mesh whose vertices are (v - origin) / length of this one's, with
    /// coordinate axis[k] as the k-th.
    void move(const Eigen::Vector3d& origin, double length, const std::array<int, 3>& axis);

    /// Calls `limit = visit(triangles)` with the triangles of each leaf whose box may be within
    /// `limit` of a box, a distance [unit]; what seems nearest first.
    template <class Visit>
    void forEachNear(const Eigen::AlignedBox3d& box, double limit, Visit&& visit) const
    {
        traverse(
            box, limit, [](const Node&, double) { return ~0U; },
            [&](std::uint32_t leaf, double) { return visit(triangles(leaf)); });
    }

    /// Calls `limit = visit(triangle)` with each triangle that may be within `limit` of p, a
    /// distance [unit]; of what seems nearest first. A negative limit ends the search. Those of a
    /// leaf are rejected by the disc around them.
    template <class Visit>
    void forEachTriangleNear(const Eigen::Vector3d& p, double limit, Visit&& visit) const;

    /// Calls `visit(triangle)` with each triangle that may be within `distance` of the straight way
    /// from `from` to `to` [unit]. Far fewer are than near a ball around the way, where that is
    /// along a wall.
    template <class Visit>
    void forEachTriangleOnWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                              double distance, Visit&& visit) const;

    /// The triangles that may be within `distance` of p, ascending, in place of what `found` had.
    void findNear(const Eigen::Vector3d& p, double distance,
                  std::vector<std::uint32_t>& found) const;

    /// All triangles, so that those side by side lie near each other.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
    [[nodiscard]] std::size_t leaves() const { return starts_.empty() ? 0 : starts_.size() - 1; }
    /// Those of a leaf, as a part of order().
    [[nodiscard]] std::span<const std::uint32_t> triangles(std::uint32_t leaf) const
    {
        return std::span(order_).subspan(starts_[leaf], starts_[leaf + 1] - starts_[leaf]);
    }

private:
    static constexpr std::size_t kWidth = 4;     // children
    static constexpr std::size_t kInLeaf = 4;    // triangles at most
    static constexpr std::size_t kDeepest = 128; // pending children: 3 a level, 2^32 triangles
    /// By which coordinates and squared distances may be wrong, twofold. [1]
    static constexpr double kGrow = 0x1p-23;
    static constexpr double kRounding = FourDiscs::kRounding;

    struct Child
    {
        std::uint32_t number = 0;    ///< of a node or a leaf
        std::uint32_t triangles = 0; ///< 0: a node
    };
    using Four = FourDiscs::Four;
    using Discs = FourDiscs;
    using Point = FourDiscs::Point;
    using Way = FourDiscs::Way;
    struct Node
    {
        std::array<Four, 3> low; ///< infinite where there is no child
        std::array<Four, 3> high;
        Discs discs; ///< with the thickness, around all that is below a child; boundless for many
        Four thickness; ///< to either side of the plane
        std::array<Child, kWidth> child;
        bool hasDiscs = false; ///< around some of the children
    };
    struct Pending
    {
        float square;
        Child child;
    };
    /// Along each axis, in the frame of the nodes, four times over.
    struct Box
    {
        std::array<Four, 3> low, high;
    };

    /// That contains `box` for certain.
    [[nodiscard]] Box around(const Eigen::AlignedBox3d& box) const;
    [[nodiscard]] static Four squaresTo(const Node& node, const Box& box);
    /// Of a distance of the mesh. Finite, so that what is not there is beyond it.
    [[nodiscard]] float squareOf(double limit) const
    {
        if (limit < 0)
        {
            return -1; // nothing is so near: the end
        }
        const double square = limit * scale_ * limit * scale_ * (1 + kRounding);
        return static_cast<float>(std::min<double>(square, std::numeric_limits<float>::max()));
    }

    [[nodiscard]] Point pointOf(const Eigen::Vector3d& p) const;
    /// Of a distance of the mesh, from the point: grown by what rounding may hide.
    [[nodiscard]] float distanceFrom(const Point& point, double limit) const
    {
        const double grown = limit * scale_ * (1 + kRounding) + point.rounding;
        return static_cast<float>(std::min(grown, kFarthest));
    }
    [[nodiscard]] Way wayOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                            double distance) const;
    /// Calls `limit = visit(leaf, limit)` for each that the boxes and select(node, limit), a bit
    /// for each child, do not rule out.
    template <class Select, class Visit>
    void traverse(const Eigen::AlignedBox3d& box, double limit, Select&& select,
                  Visit&& visit) const;

    /// Calls visit(triangle) for those of a leaf whose bit is set.
    template <class Visit>
    void forEachOf(std::uint32_t leaf, unsigned bits, Visit&& visit) const
    {
        const std::span<const std::uint32_t> its = triangles(leaf);
        for (bits &= (1U << its.size()) - 1; bits != 0; bits &= bits - 1)
        {
            visit(its[static_cast<std::size_t>(std::countr_zero(bits))]);
        }
    }

    class Builder;
    static constexpr double kFarthest = 1e15; // whose square is finite

    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(); ///< of the mesh
    double scale_ = 1;                                 ///< by which it has the size 1
    std::vector<Node> nodes_;                          ///< the first is the root
    std::vector<Discs> leaves_;                        ///< of triangles; zero where one is missing
    std::vector<std::uint32_t> starts_;                ///< [#leaves + 1] in order_
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
        result.low[at] =
            FourDiscs::fourTimes(static_cast<float>(low - kGrow * (1 + std::abs(low))));
        result.high[at] =
            FourDiscs::fourTimes(static_cast<float>(high + kGrow * (1 + std::abs(high))));
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

inline TriangleBvh::Point TriangleBvh::pointOf(const Eigen::Vector3d& p) const
{
    Point point{};
    double largest = 1;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
        const double at = (p[axis] - centre_[axis]) * scale_;
        point.at[static_cast<std::size_t>(axis)] = FourDiscs::fourTimes(static_cast<float>(at));
        largest = std::max(largest, std::abs(at));
    }
    point.rounding = static_cast<float>(kRounding * largest);
    return point;
}

inline TriangleBvh::Way TriangleBvh::wayOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                           double distance) const
{
    Way way{};
    way.middle = pointOf((from + to) / 2);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const auto at = static_cast<Eigen::Index>(axis);
        way.half[axis] = FourDiscs::fourTimes(static_cast<float>((to[at] - from[at]) / 2 * scale_));
    }
    way.reach = distanceFrom(way.middle, distance);
    way.ball = distanceFrom(way.middle, distance + (to - from).norm() / 2);
    return way;
}

template <class Select, class Visit>
void TriangleBvh::traverse(const Eigen::AlignedBox3d& box, double limit, Select&& select,
                           Visit&& visit) const
{
    if (nodes_.empty())
    {
        return;
    }
    std::array<Pending, kDeepest> pending;
    pending[0] = {0, {0, 0}}; // the root
    std::size_t count = 1;
    const Box from = around(box);
    float square = squareOf(limit);
    while (count > 0)
    {
        const Pending next = pending[--count];
        if (next.square > square)
        {
            continue;
        }
        if (next.child.triangles > 0)
        {
            limit = visit(next.child.number, limit);
            square = squareOf(limit);
            continue;
        }
        const Node& node = nodes_[next.child.number];
        const Four squares = squaresTo(node, from);
        unsigned selected = FourDiscs::bitsOf(squares <= FourDiscs::fourTimes(square));
        if (selected != 0)
        {
            selected &= select(node, limit);
        }
        const std::size_t begin = count;
        for (; selected != 0; selected &= selected - 1)
        {
            // Sorted as they come: the nearest is the last, which is taken first.
            const auto k = static_cast<std::size_t>(std::countr_zero(selected));
            std::size_t place = count++;
            for (; place > begin && pending[place - 1].square < squares[k]; --place)
            {
                pending[place] = pending[place - 1];
            }
            pending[place] = {squares[k], node.child[k]};
        }
    }
}

template <class Visit>
void TriangleBvh::forEachTriangleNear(const Eigen::Vector3d& p, double limit, Visit&& visit) const
{
    const Point point = pointOf(p);
    const auto select = [&](const Node& node, double within)
    {
        return node.hasDiscs
                   ? node.discs.mayBeWithin(node.thickness, point, distanceFrom(point, within))
                   : ~0U;
    };
    const auto visitLeaf = [&](std::uint32_t leaf, double within)
    {
        forEachOf(leaf, leaves_[leaf].mayBeWithin(Four{}, point, distanceFrom(point, within)),
                  [&](std::uint32_t triangle) { within = visit(triangle); });
        return within;
    };
    traverse(Eigen::AlignedBox3d(p), limit, select, visitLeaf);
}

template <class Visit>
void TriangleBvh::forEachTriangleOnWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                       double distance, Visit&& visit) const
{
    const Way way = wayOf(from, to, distance);
    const auto select = [&](const Node& node, double)
    { return node.hasDiscs ? node.discs.mayBeOnWay(node.thickness, way) : ~0U; };
    const auto visitLeaf = [&](std::uint32_t leaf, double limit)
    {
        forEachOf(leaf, leaves_[leaf].mayBeOnWay(Four{}, way), visit);
        return limit;
    };
    traverse(Eigen::AlignedBox3d(from.cwiseMin(to), from.cwiseMax(to)), distance, select,
             visitLeaf);
}

/// A point of a mesh.
struct NearestPoint
{
    Eigen::Vector3d point;
    std::uint32_t triangle; ///< that has it; the first of several
    double distance;        ///< [unit]
};
/// The point of a mesh with this hierarchy that is nearest to p; empty if none is nearer than
/// `within`, which may be infinite.
[[nodiscard]] std::optional<NearestPoint> nearestPoint(const TriangleMesh& mesh,
                                                       const TriangleBvh& bvh,
                                                       const Eigen::Vector3d& p, double within);

} // namespace frostfill
