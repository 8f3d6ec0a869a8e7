// SPDX-License-Identifier: MIT
#include "mesh/interior/walls.hpp"

#include "geometry/exact_predicates.hpp"
#include "mesh/interior/winding_columns.hpp"
#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace frostfill
{
namespace
{

/// [1] Share of the product of the lengths by which a determinant must differ from 0. Larger: more
/// fans are tested pair by pair. Below some 10 roundings of 1e-16: a fold is taken for a fan.
constexpr double kSurely = 1e-13;

/// A triangle as seen from a vertex.
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

/// Whether wedges, sorted by where they begin, are passed one after the other on one way round.
bool areOneFan(std::span<const Wedge> wedges)
{
    std::size_t at = 0;
    std::size_t passed = 0;
    do
    {
        const auto next = std::lower_bound(wedges.begin(), wedges.end(), wedges[at].to,
                                           [](const Wedge& wedge, std::uint32_t vertex)
                                           { return wedge.from < vertex; });
        if (next == wedges.end() || next->from != wedges[at].to ||
            (next + 1 != wedges.end() && next[1].from == next->from))
        {
            return false;
        }
        at = static_cast<std::size_t>(next - wedges.begin());
        ++passed;
    } while (at != 0 && passed <= wedges.size());
    return passed == wedges.size();
}

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

bool haveCommon(const Triangle& a, const Triangle& b)
{
    // Without a branch for each: this is asked for every pair that comes near each other.
    const auto has = [&](std::uint32_t vertex)
    { return unsigned{vertex == b[0]} | unsigned{vertex == b[1]} | unsigned{vertex == b[2]}; };
    return (has(a[0]) | has(a[1]) | has(a[2])) != 0;
}

class WallSearch
{
public:
    WallSearch(const TriangleMesh& mesh, const MeshIndex& index)
        : mesh_(mesh), tree_(index.tree), threads_(*index.threads), boxes_(mesh.triangles.size()),
          marks_(mesh.triangles.size())
    {
        threads_.forEach(boxes_.size(),
                         [&](std::size_t place) { boxes_[place] = boxOf(tree_.order()[place]); });
        searchFans();
        searchTree();
    }

    [[nodiscard]] Crossings crossings() const
    {
        Crossings found;
        for (std::uint32_t t = 0; t < marks_.size(); ++t)
        {
            found.crossed.push_back(isMarked(t, kCrossed));
            found.count += found.crossed[t] ? 1 : 0;
        }
        found.firstPlace = found.count > 0 ? firstPlace() : found.firstPlace;
        return found;
    }
    /// Whether a triangle is at a vertex of several fans.
    [[nodiscard]] bool isAtSeveralFans(std::uint32_t triangle) const
    {
        return isMarked(triangle, kAtSeveralFans);
    }

private:
    // What a thread looks at in one go. Larger: threads wait for the last. Smaller: they are in
    // each other's way.
    static constexpr std::size_t kTogether = 1 << 11;
    static constexpr std::uint8_t kCrossed = 1;
    static constexpr std::uint8_t kAtSeveralFans = 2;

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

    // All pairs with a common vertex.
    void searchFans()
    {
        std::vector<bool> solid(boxes_.size());
        for (std::size_t place = 0; place < boxes_.size(); ++place)
        {
            solid[tree_.order()[place]] = !boxes_[place].isEmpty();
        }
        const VertexTriangles around(mesh_);
        const auto search = [&](std::uint32_t vertex)
        {
            const std::span<const std::uint32_t> its = around.at(vertex);
            const Fan fan = its.empty() ? Fan::spread : fanAt(mesh_, vertex, its);
            for (std::size_t i = 0; fan != Fan::spread && i < its.size(); ++i)
            {
                mark(its[i], fan == Fan::several ? kAtSeveralFans : std::uint8_t{0});
                for (std::size_t j = 0; j < i; ++j)
                {
                    if (solid[its[i]] && solid[its[j]])
                    {
                        test(its[i], its[j]);
                    }
                }
            }
        };
        forEachPart(threads_, around.vertices(), kTogether,
                    [&](std::size_t first, std::size_t last, std::size_t)
                    {
                        for (std::size_t vertex = first; vertex < last; ++vertex)
                        {
                            search(static_cast<std::uint32_t>(vertex));
                        }
                    });
    }

    // All other pairs: those within a leaf, and between it and others that come near.
    void searchTree()
    {
        const auto searchLeaf = [&](std::uint32_t leaf)
        {
            const std::span<const std::uint32_t> ours = tree_.triangles(leaf);
            const std::size_t begin = placeOf(ours);
            Eigen::AlignedBox3d box;
            for (std::size_t i = 0; i < ours.size(); ++i)
            {
                box.extend(boxes_[begin + i]);
            }
            const auto compareWith = [&](std::span<const std::uint32_t> theirs)
            {
                const std::size_t place = placeOf(theirs);
                for (std::size_t i = begin; place >= begin && i < begin + ours.size(); ++i)
                {
                    for (std::size_t j = std::max(place, i + 1); j < place + theirs.size(); ++j)
                    {
                        compare(i, j);
                    }
                }
                return 0.0;
            };
            if (!box.isEmpty())
            {
                tree_.forEachNear(box, 0, compareWith);
            }
        };
        forEachPart(threads_, tree_.leaves(), kTogether,
                    [&](std::size_t first, std::size_t last, std::size_t)
                    {
                        for (std::size_t leaf = first; leaf < last; ++leaf)
                        {
                            searchLeaf(static_cast<std::uint32_t>(leaf));
                        }
                    });
    }

    [[nodiscard]] std::size_t placeOf(std::span<const std::uint32_t> leaf) const
    {
        return static_cast<std::size_t>(leaf.data() - tree_.order().data());
    }

    void compare(std::size_t place, std::size_t other)
    {
        const std::uint32_t a = tree_.order()[place];
        const std::uint32_t b = tree_.order()[other];
        if (boxes_[place].intersects(boxes_[other]) &&
            !haveCommon(mesh_.triangles[a], mesh_.triangles[b]))
        {
            test(a, b);
        }
    }

    void test(std::uint32_t one, std::uint32_t other)
    {
        // What is known need not be shown again: many triangles at one place stay cheap.
        if ((!isMarked(one, kCrossed) || !isMarked(other, kCrossed)) &&
            trianglesCross(pairOf(mesh_, one, other)))
        {
            mark(one, kCrossed);
            mark(other, kCrossed);
        }
    }

    void mark(std::uint32_t triangle, std::uint8_t what)
    {
        marks_[triangle].fetch_or(what, std::memory_order_relaxed);
    }
    [[nodiscard]] bool isMarked(std::uint32_t triangle, std::uint8_t what) const
    {
        return (marks_[triangle].load(std::memory_order_relaxed) & what) != 0;
    }

    [[nodiscard]] Eigen::Vector3d firstPlace() const
    {
        std::uint32_t first = 0;
        while (!isMarked(first, kCrossed))
        {
            ++first;
        }
        const Eigen::AlignedBox3d box = boxOf(first);
        for (std::uint32_t other = first + 1; other < marks_.size(); ++other)
        {
            if (isMarked(other, kCrossed) && box.intersects(boxOf(other)) &&
                trianglesCross(pairOf(mesh_, first, other)))
            {
                return box.intersection(boxOf(other)).center();
            }
        }
        return box.center();
    }

    const TriangleMesh& mesh_;
    const TriangleBvh& tree_;
    Threads& threads_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#T] in the order of the tree
    /// [#T] All threads enter what they find; which of them is first makes no difference.
    std::vector<std::atomic<std::uint8_t>> marks_;
};

using Flags = std::vector<bool>; ///< [#T]

/// The triangles of each patch of those without a flag, connected over edges of two.
std::vector<std::vector<std::uint32_t>> findPatches(const EdgeTable& edges, const Flags& flags)
{
    DisjointSets sets = connectedOver(edges, flags.size(),
                                      [&](std::span<const EdgeUse> uses) {
                                          return uses.size() == 2 && !flags[uses[0].triangle] &&
                                                 !flags[uses[1].triangle];
                                      });
    std::vector<std::vector<std::uint32_t>> patches;
    std::vector<std::size_t> patchOf(flags.size());
    for (std::uint32_t t = 0; t < flags.size(); ++t)
    {
        const std::size_t root = sets.find(t); // the smallest, which has been here already
        if (!flags[t])
        {
            patchOf[t] = root == t ? patches.size() : patchOf[root];
            patches.resize(std::max(patches.size(), patchOf[t] + 1));
            patches[patchOf[t]].push_back(t);
        }
    }
    return patches;
}

/// Whether a patch has the winding number 0 in front and 1 behind. Nothing passes through it, so
/// one place speaks for all. The largest triangle is the safest from rounding.
bool partsOutsideFromInside(const TriangleMesh& mesh, const WindingColumns& winding,
                            std::span<const std::uint32_t> patch)
{
    const auto isSmaller = [&](std::uint32_t a, std::uint32_t b)
    { return areaOf(mesh, mesh.triangles[a]) < areaOf(mesh, mesh.triangles[b]); };
    const auto [a, b, c] =
        cornersOf(mesh, *std::max_element(patch.begin(), patch.end(), isSmaller));
    const Eigen::Vector3d outward = (b - a).cross(c - a).stableNormalized();
    const auto [front, behind] = winding.sidesOf((a + b + c) / 3, outward);
    return front == 0 && behind == 1;
}

void flagNeighbours(const TriangleMesh& mesh, Flags& flags)
{
    std::vector<bool> atVertex(mesh.vertices.size(), false);
    for (std::size_t triangle = 0; triangle < flags.size(); ++triangle)
    {
        if (flags[triangle])
        {
            for (const std::uint32_t corner : mesh.triangles[triangle])
            {
                atVertex[corner] = true;
            }
        }
    }
    for (std::size_t triangle = 0; triangle < flags.size(); ++triangle)
    {
        const auto& t = mesh.triangles[triangle];
        flags[triangle] = atVertex[t[0]] || atVertex[t[1]] || atVertex[t[2]];
    }
}

std::size_t countOf(const Flags& flags)
{
    return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

} // namespace

Fan fanAt(const TriangleMesh& mesh, std::uint32_t vertex, std::span<const std::uint32_t> triangles)
{
    thread_local std::vector<Wedge> wedges; // keeps its memory
    wedges.clear();
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    for (const std::uint32_t triangle : triangles)
    {
        wedges.push_back(wedgeOf(mesh, vertex, triangle));
        axis += wedges.back().normal;
    }
    std::sort(wedges.begin(), wedges.end(),
              [](const Wedge& a, const Wedge& b) { return a.from < b.from; });
    if (!areOneFan(wedges))
    {
        return Fan::several;
    }
    const double axisLength = axis.norm();
    const auto turnsForward = [&](const Wedge& w)
    { return w.normal.dot(axis) > kSurely * w.uLength * w.vLength * axisLength; };
    if (!std::all_of(wedges.begin(), wedges.end(), turnsForward))
    {
        return Fan::folded;
    }
    // Closed and never backwards: every direction about the axis is in equally many wedges. One
    // direction in the first wedge is in no other, so that is one.
    const Eigen::Vector3d middle =
        wedges[0].u / wedges[0].uLength + wedges[0].v / wedges[0].vLength;
    const Eigen::Vector3d across = middle.cross(axis);
    const double margin = kSurely * 2 * axisLength;
    const bool isOnce = std::all_of(wedges.begin() + 1, wedges.end(),
                                    [&](const Wedge& w)
                                    {
                                        // det(axis, u, middle) = u . (middle x axis)
                                        return w.u.dot(across) < -margin * w.uLength ||
                                               w.v.dot(across) > margin * w.vLength;
                                    });
    return isOnce ? Fan::spread : Fan::folded;
}

Crossings findCrossings(const TriangleMesh& mesh, const MeshIndex& index)
{
    return WallSearch(mesh, index).crossings();
}

Walls classifyWalls(const TriangleMesh& mesh)
{
    return classifyWalls(mesh, MeshIndex(mesh));
}

Walls classifyWalls(const TriangleMesh& mesh, const MeshIndex& index)
{
    const WallSearch search(mesh, index);
    Crossings crossings = search.crossings();
    Walls walls;
    walls.crossed = crossings.count;
    walls.firstCrossing = crossings.firstPlace;
    walls.twoSided = std::move(crossings.crossed);
    for (std::uint32_t t = 0; t < walls.twoSided.size(); ++t)
    {
        walls.twoSided[t] =
            walls.twoSided[t] || search.isAtSeveralFans(t) || !hasArea(cornersOf(mesh, t));
    }
    index.edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (std::size_t k = 0; (uses.size() != 2 || !cancels(uses)) && k < uses.size(); ++k)
            {
                walls.twoSided[uses[k].triangle] = true;
            }
        });
    const auto patches = findPatches(index.edges, walls.twoSided);
    if (patches.size() > 1 || countOf(walls.twoSided) > 0)
    {
        const WindingColumns winding(mesh);
        for (const std::vector<std::uint32_t>& patch : patches)
        {
            if (!partsOutsideFromInside(mesh, winding, patch))
            {
                std::for_each(patch.begin(), patch.end(),
                              [&](auto triangle) { walls.twoSided[triangle] = true; });
            }
        }
        flagNeighbours(mesh, walls.twoSided);
    }
    walls.count = countOf(walls.twoSided);
    return walls;
}

} // namespace frostfill
