// SPDX-License-Identifier: MIT
#include "mesh/interior/crossings.hpp"

#include "geometry/triangle_pair.hpp"
#include "mesh/triangle_shape.hpp"

#include <frostfill/mesh.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

/// [1] Margin of a box for the rounding of unit vectors. Smaller: arcs that meet are missed.
constexpr double kRounding = 1e-14;

Eigen::AlignedBox3d boxOfArc(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t vertex)
{
    const auto& t = mesh.triangles[triangle];
    const std::size_t corner = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
    const Eigen::Vector3d& from = mesh.vertices[vertex];
    const Eigen::Vector3d u = (mesh.vertices[t[(corner + 1) % 3]] - from).normalized();
    const Eigen::Vector3d v = (mesh.vertices[t[(corner + 2) % 3]] - from).normalized();
    // How far the arc rises above its chord.
    const double rise = std::max(0.0, 1 - (u + v).norm() / 2) + kRounding;
    return {u.cwiseMin(v).array() - rise, u.cwiseMax(v).array() + rise};
}

/// Finds which triangles at a vertex may meet elsewhere too. Seen from the vertex a triangle is an
/// arc on the unit sphere, and two triangles meet exactly if their arcs do. Boxes around the arcs
/// of needles are small, though the boxes around the needles themselves all overlap.
class FanSweep
{
public:
    /// Calls visit(one, other) once for each pair of `triangles` whose arcs have boxes that meet.
    /// All triangles have the vertex as a corner.
    template <class Visit>
    void forEachPair(const TriangleMesh& mesh, std::uint32_t vertex,
                     std::span<const std::uint32_t> triangles, Visit&& visit)
    {
        const int axis = sortArcs(mesh, vertex, triangles);
        for (std::size_t i = 0; i < arcs_.size(); ++i)
        {
            const Arc& arc = arcs_[i];
            for (std::size_t j = i + 1;
                 j < arcs_.size() && arcs_[j].box.min()[axis] <= arc.box.max()[axis]; ++j)
            {
                if (arc.box.intersects(arcs_[j].box))
                {
                    visit(arc.triangle, arcs_[j].triangle);
                }
            }
        }
    }

private:
    struct Arc
    {
        Eigen::AlignedBox3d box; ///< of directions
        std::uint32_t triangle = 0;
    };

    /// Sorts the arcs along the axis on which they spread most. Returns that axis.
    int sortArcs(const TriangleMesh& mesh, std::uint32_t vertex,
                 std::span<const std::uint32_t> triangles)
    {
        arcs_.clear();
        Eigen::AlignedBox3d whole;
        for (const std::uint32_t triangle : triangles)
        {
            arcs_.push_back({boxOfArc(mesh, triangle, vertex), triangle});
            whole.extend(arcs_.back().box.center());
        }
        int axis = 0;
        whole.sizes().maxCoeff(&axis);
        std::sort(arcs_.begin(), arcs_.end(),
                  [=](const Arc& a, const Arc& b) {
                      return std::tie(a.box.min()[axis], a.triangle) <
                             std::tie(b.box.min()[axis], b.triangle);
                  });
        return axis;
    }

    std::vector<Arc> arcs_; // kept for its memory
};

/// Two triangles with the vertices that they share in front.
TrianglePair pairOf(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other)
{
    auto a = mesh.triangles[one];
    auto b = mesh.triangles[other];
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto same = std::find(b.begin() + shared, b.end(), a[i]);
        if (same != b.end())
        {
            std::swap(*same, b[shared]);
            std::swap(a[i], a[shared]);
            ++shared;
        }
    }
    TrianglePair pair;
    for (std::size_t k = 0; k < 3; ++k)
    {
        pair.a[k] = mesh.vertices[a[k]];
        pair.b[k] = mesh.vertices[b[k]];
    }
    pair.shared = static_cast<int>(shared);
    return pair;
}

/// The vertices that all triangles of a node have, first; then kNone.
using Common = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = 0xffffffff;

Common commonOf(const Common& a, const Common& b)
{
    Common both = {kNone, kNone, kNone};
    std::copy_if(a.begin(), a.end(), both.begin(),
                 [&](std::uint32_t vertex)
                 { return std::find(b.begin(), b.end(), vertex) != b.end(); });
    return both;
}

bool haveCommon(const Common& a, const Common& b)
{
    // Without a branch for each: this is asked for every pair of nodes that come near each other.
    const auto has = [&](std::uint32_t vertex)
    {
        const unsigned same =
            unsigned{vertex == b[0]} | unsigned{vertex == b[1]} | unsigned{vertex == b[2]};
        return same & unsigned{vertex != kNone};
    };
    return (has(a[0]) | has(a[1]) | has(a[2])) != 0;
}

class CrossingSearch
{
public:
    CrossingSearch(const TriangleMesh& mesh, const TriangleTree& tree, Threads& threads)
        : mesh_(mesh), tree_(tree), threads_(threads), boxes_(mesh.triangles.size()),
          crossed_(mesh.triangles.size())
    {
        threads.forEach(boxes_.size(),
                        [&](std::size_t place) { boxes_[place] = boxOf(tree_.order()[place]); });
        // What is below a node stands behind it.
        nodes_.resize(tree_.nodes().size());
        for (std::size_t node = nodes_.size(); node-- > 0;)
        {
            nodes_[node] = tree_.isLeaf(node) ? ofLeaf(tree_.nodes()[node]) : ofInner(node);
        }
    }

    Crossings run(const VertexTriangles& around)
    {
        searchFans(around);
        searchTree();
        return result();
    }

private:
    // What a thread looks at in one go. Larger: threads wait for the last. Smaller: they are in
    // each other's way.
    static constexpr std::size_t kVerticesTogether = 1 << 11;
    static constexpr std::uint32_t kTrianglesTogether = 1 << 12;

    /// Of vertices or nodes.
    struct Range
    {
        std::size_t first;
        std::size_t end;
    };
    struct Node
    {
        Eigen::AlignedBox3d box;
        Common common;
    };

    /// Empty for a triangle without area, which then meets nothing.
    [[nodiscard]] Eigen::AlignedBox3d boxOf(std::uint32_t triangle) const
    {
        Eigen::AlignedBox3d box;
        const TrianglePair::Corners corners = cornersOf(mesh_, triangle);
        if (hasArea(corners))
        {
            box.extend(corners[0]).extend(corners[1]).extend(corners[2]);
        }
        return box;
    }

    [[nodiscard]] std::size_t secondChild(std::size_t node) const
    {
        return tree_.nodes()[node + 1].skip;
    }

    [[nodiscard]] Node ofInner(std::size_t node) const
    {
        const Node& one = nodes_[node + 1];
        const Node& other = nodes_[secondChild(node)];
        return {one.box.merged(other.box), commonOf(one.common, other.common)};
    }

    [[nodiscard]] Node ofLeaf(const TriangleTree::Node& node) const
    {
        Node result{{}, mesh_.triangles[tree_.order()[node.first]]};
        for (std::uint32_t place = node.first; place < node.end; ++place)
        {
            result.box.extend(boxes_[place]);
            result.common = commonOf(result.common, mesh_.triangles[tree_.order()[place]]);
        }
        return result;
    }

    // All pairs with a common vertex.
    void searchFans(const VertexTriangles& around)
    {
        std::vector<bool> solid(mesh_.triangles.size(), false);
        for (std::size_t place = 0; place < boxes_.size(); ++place)
        {
            solid[tree_.order()[place]] = !boxes_[place].isEmpty();
        }
        forEachPart(threads_, around.vertices(), kVerticesTogether,
                    [&](std::size_t first, std::size_t last, std::size_t) {
                        searchFans(around, solid, {first, last});
                    });
    }

    void searchFans(const VertexTriangles& around, const std::vector<bool>& solid,
                    const Range& vertices)
    {
        FanSweep sweep;
        for (auto vertex = static_cast<std::uint32_t>(vertices.first); vertex < vertices.end;
             ++vertex)
        {
            if (isSpreadFan(mesh_, vertex, around.at(vertex)))
            {
                continue;
            }
            sweep.forEachPair(mesh_, vertex, around.at(vertex),
                              [&](std::uint32_t one, std::uint32_t other)
                              {
                                  if (solid[one] && solid[other])
                                  {
                                      test(one, other, [&] { return pairOf(mesh_, one, other); });
                                  }
                              });
        }
    }

    // All other pairs: those within a node are those within its children and those between them.
    void searchTree()
    {
        const std::vector<Range> parts = partsOfTree();
        threads_.forEachLarge(parts.size(), [&](std::size_t k) { searchNodes(parts[k]); });
    }

    /// Small parts of the tree, each by itself, and each of the nodes above them.
    [[nodiscard]] std::vector<Range> partsOfTree() const
    {
        std::vector<Range> parts;
        for (std::size_t node = 0; node < nodes_.size(); node = parts.back().end)
        {
            const TriangleTree::Node& its = tree_.nodes()[node];
            const bool isSmall = its.end - its.first <= kTrianglesTogether;
            parts.push_back({node, isSmall ? its.skip : node + 1});
        }
        return parts;
    }

    void searchNodes(const Range& nodes)
    {
        for (std::size_t node = nodes.first; node < nodes.end; ++node)
        {
            if (tree_.isLeaf(node))
            {
                compare(node, node);
            }
            else
            {
                searchBetween(node + 1, secondChild(node));
            }
        }
    }

    // The larger node is opened first. As deep as both halves of the tree at most.
    void searchBetween(std::size_t one, std::size_t other)
    {
        if (!nodes_[one].box.intersects(nodes_[other].box) ||
            haveCommon(nodes_[one].common, nodes_[other].common))
        {
            return;
        }
        if (tree_.isLeaf(one) && tree_.isLeaf(other))
        {
            compare(one, other);
            return;
        }
        const auto sizeOf = [&](std::size_t node)
        { return tree_.nodes()[node].end - tree_.nodes()[node].first; };
        const bool opensOne =
            !tree_.isLeaf(one) && (tree_.isLeaf(other) || sizeOf(one) >= sizeOf(other));
        const std::size_t opened = opensOne ? one : other;
        const std::size_t kept = opensOne ? other : one;
        searchBetween(opened + 1, kept);
        searchBetween(secondChild(opened), kept);
    }

    void compare(std::size_t leaf, std::size_t other)
    {
        const TriangleTree::Node& ours = tree_.nodes()[leaf];
        const TriangleTree::Node& theirs = tree_.nodes()[other];
        for (std::uint32_t i = ours.first; i < ours.end; ++i)
        {
            if (!boxes_[i].intersects(nodes_[other].box))
            {
                continue;
            }
            const std::uint32_t one = tree_.order()[i];
            const std::uint32_t first = leaf == other ? i + 1 : theirs.first;
            for (std::uint32_t j = first; j < theirs.end; ++j)
            {
                const std::uint32_t two = tree_.order()[j];
                if (boxes_[i].intersects(boxes_[j]) &&
                    !haveCommon(mesh_.triangles[one], mesh_.triangles[two]))
                {
                    test(one, two,
                         [&] {
                             return TrianglePair{cornersOf(mesh_, one), cornersOf(mesh_, two), 0};
                         });
                }
            }
        }
    }

    template <class MakePair>
    void test(std::uint32_t one, std::uint32_t other, MakePair&& makePair)
    {
        // What is known need not be shown again: many triangles at one place stay cheap.
        if ((!isCrossed(one) || !isCrossed(other)) && trianglesCross(makePair()))
        {
            crossed_[one].store(true, std::memory_order_relaxed);
            crossed_[other].store(true, std::memory_order_relaxed);
        }
    }

    [[nodiscard]] bool isCrossed(std::uint32_t triangle) const
    {
        return crossed_[triangle].load(std::memory_order_relaxed);
    }

    Crossings result()
    {
        Crossings found;
        found.crossed.assign(crossed_.begin(), crossed_.end());
        found.count =
            static_cast<std::size_t>(std::count(found.crossed.begin(), found.crossed.end(), true));
        if (found.count > 0)
        {
            found.firstPlace = firstPlace();
        }
        return found;
    }

    [[nodiscard]] Eigen::Vector3d firstPlace() const
    {
        const auto first = static_cast<std::uint32_t>(
            std::find(crossed_.begin(), crossed_.end(), true) - crossed_.begin());
        const Eigen::AlignedBox3d box = boxOf(first);
        for (std::uint32_t other = first + 1; other < crossed_.size(); ++other)
        {
            if (isCrossed(other) && box.intersects(boxOf(other)))
            {
                const TrianglePair pair = pairOf(mesh_, first, other);
                if (trianglesCross(pair))
                {
                    return crossingPlace(pair);
                }
            }
        }
        return box.center();
    }

    const TriangleMesh& mesh_;
    const TriangleTree& tree_;
    Threads& threads_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#T] in the order of the tree
    std::vector<Node> nodes_;                ///< [#nodes]
    /// [#T] All threads enter what they find; which of them is first makes no difference.
    std::vector<std::atomic<bool>> crossed_;
};

} // namespace

Crossings findCrossings(const TriangleMesh& mesh, const VertexTriangles& around,
                        const TriangleTree& tree, Threads& threads)
{
    return CrossingSearch(mesh, tree, threads).run(around);
}

namespace
{

constexpr std::size_t kMax = 16; // triangles; beyond, all against all costs more than a sweep

/// [1] Share of the product of the lengths by which a determinant must differ from 0. Larger: more
/// fans are tested pair by pair. Below some 10 roundings of 1e-16: a fold is taken for a fan.
constexpr double kSurely = 1e-13;

struct Wedge
{
    std::uint32_t from = 0; ///< vertex
    std::uint32_t to = 0;   ///< vertex
    Eigen::Vector3d u, v;   ///< from the common vertex to both
    Eigen::Vector3d normal; ///< u x v
    double uLength = 0, vLength = 0;
};

Wedge wedgeOf(const TriangleMesh& mesh, std::uint32_t vertex, std::uint32_t triangle)
{
    const auto& t = mesh.triangles[triangle];
    const std::size_t corner = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
    Wedge wedge;
    wedge.from = t[(corner + 1) % 3];
    wedge.to = t[(corner + 2) % 3];
    wedge.u = mesh.vertices[wedge.from] - mesh.vertices[vertex];
    wedge.v = mesh.vertices[wedge.to] - mesh.vertices[vertex];
    wedge.normal = wedge.u.cross(wedge.v);
    wedge.uLength = wedge.u.norm();
    wedge.vLength = wedge.v.norm();
    return wedge;
}

/// Each wedge ends where exactly one begins, so the wedges form closed fans.
bool areClosed(std::span<const Wedge> wedges)
{
    return std::all_of(wedges.begin(), wedges.end(),
                       [&](const Wedge& wedge)
                       {
                           return std::count_if(wedges.begin(), wedges.end(),
                                                [&](const Wedge& next)
                                                { return next.from == wedge.to; }) == 1;
                       });
}

} // namespace

bool isSpreadFan(const TriangleMesh& mesh, std::uint32_t vertex,
                 std::span<const std::uint32_t> triangles)
{
    if (triangles.empty() || triangles.size() > kMax)
    {
        return false;
    }
    std::array<Wedge, kMax> all;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        all[i] = wedgeOf(mesh, vertex, triangles[i]);
        axis += all[i].normal;
    }
    const std::span wedges(all.data(), triangles.size());
    const double axisLength = axis.norm();
    const auto turnsForward = [&](const Wedge& w)
    { return w.normal.dot(axis) > kSurely * w.uLength * w.vLength * axisLength; };
    if (!std::all_of(wedges.begin(), wedges.end(), turnsForward) || !areClosed(wedges))
    {
        return false;
    }

    // Closed and never backwards: every direction about the axis is in equally many wedges. One
    // direction in the first wedge is in no other, so that is one.
    const Eigen::Vector3d middle =
        wedges[0].u / wedges[0].uLength + wedges[0].v / wedges[0].vLength;
    const Eigen::Vector3d across = middle.cross(axis);
    const double margin = kSurely * 2 * axisLength;
    return std::all_of(wedges.begin() + 1, wedges.end(),
                       [&](const Wedge& w)
                       {
                           // det(axis, u, middle) = u . (middle x axis)
                           return w.u.dot(across) < -margin * w.uLength ||
                                  w.v.dot(across) > margin * w.vLength;
                       });
}

} // namespace frostfill
