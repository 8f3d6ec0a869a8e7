// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace frostfill
{

namespace
{

/// Triangles, below which a part is not shared among threads any more.
constexpr std::size_t kSmallPart = 1 << 12;

/// Nodes of a tree of so many triangles. The parts of a level differ by one triangle at most.
std::uint32_t nodesOf(std::size_t triangles, std::size_t leafSize)
{
    std::size_t nodes = 0;
    std::size_t size = triangles;
    std::size_t parts = 1;  // of this size
    std::size_t larger = 0; // parts, by one
    while (parts + larger > 0)
    {
        nodes += parts + larger;
        parts = size > leafSize ? parts : 0;
        larger = size + 1 > leafSize ? larger : 0;
        const bool isOdd = size % 2 == 1;
        size /= 2;
        const std::size_t halved = parts;
        parts = isOdd ? halved : 2 * halved + larger;
        larger = isOdd ? halved + 2 * larger : larger;
    }
    return static_cast<std::uint32_t>(nodes);
}

} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize)
{
    Threads one(1);
    *this = TriangleTree(mesh, leafSize, one);
}

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::uint32_t leafSize, Threads& threads)
    : order_(mesh.triangles.size())
{
    std::vector<Item> items(mesh.triangles.size());
    threads.forEach(items.size(),
                    [&](std::size_t id)
                    {
                        const auto& t = mesh.triangles[id];
                        items[id] = {
                            (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3,
                            static_cast<std::uint32_t>(id)};
                    });
    if (!items.empty())
    {
        nodes_.resize(nodesOf(items.size(), leafSize));
        build({items, 0, 0}, leafSize, threads);
    }
    threads.forEach(items.size(),
                    [&](std::size_t place) { order_[place] = items[place].triangle; });
}

// Level by level, until there is a part for every thread, and some more.
void TriangleTree::build(const Part& root, std::uint32_t leafSize, Threads& threads)
{
    std::vector<Part> parts = {root};
    while (parts.size() < 4 * threads.concurrency() && threads.concurrency() > 1 &&
           parts[0].items.size() > std::max<std::size_t>(kSmallPart, leafSize))
    {
        std::vector<Part> halves(2 * parts.size());
        threads.forEachLarge(parts.size(),
                             [&](std::size_t k)
                             {
                                 const auto [lower, upper] = halve(parts[k], leafSize);
                                 halves[2 * k] = lower;
                                 halves[2 * k + 1] = upper;
                             });
        parts = std::move(halves);
    }
    threads.forEachLarge(parts.size(), [&](std::size_t k) { split(parts[k], leafSize); });
}

// Each call halves its triangles, so a million of them take 20 nested calls, however they lie.
void TriangleTree::split(const Part& part, std::uint32_t leafSize)
{
    if (part.items.size() > leafSize)
    {
        for (const Part& half : halve(part, leafSize))
        {
            split(half, leafSize);
        }
        return;
    }
    std::sort(part.items.begin(), part.items.end(),
              [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
    const auto count = static_cast<std::uint32_t>(part.items.size());
    nodes_[part.node] = {part.first, part.first + count, part.node + 1};
}

std::array<TriangleTree::Part, 2> TriangleTree::halve(const Part& part, std::uint32_t leafSize)
{
    const std::span<Item> items = part.items;
    Eigen::AlignedBox3d box;
    std::for_each(items.begin(), items.end(), [&](const Item& item) { box.extend(item.centroid); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = items.size() / 2;
    // Equal centroids are told apart by their number, so the halves depend on no library.
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                     items.end(),
                     [axis](const Item& a, const Item& b)
                     {
                         const double one = a.centroid[axis];
                         const double other = b.centroid[axis];
                         return one < other || (one == other && a.triangle < b.triangle);
                     });
    const auto count = static_cast<std::uint32_t>(items.size());
    nodes_[part.node] = {part.first, part.first + count,
                         part.node + nodesOf(items.size(), leafSize)};
    return {Part{items.first(middle), part.first, part.node + 1},
            Part{items.subspan(middle), part.first + static_cast<std::uint32_t>(middle),
                 part.node + 1 + nodesOf(middle, leafSize)}};
}

} // namespace frostfill
