// SPDX-License-Identifier: MIT
#include "mesh/interior/crossings.hpp"

#include "geometry/triangle_pair.hpp"
#include "mesh/interior/fan_sweep.hpp"
#include "mesh/interior/spread_fan.hpp"
#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <utility>

namespace frostfill
{
namespace
{

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

} // namespace frostfill
