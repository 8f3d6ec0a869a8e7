// SPDX-License-Identifier: MIT
#include "mesh/interior/separate_boxes.hpp"

#include "mesh/disjoint_sets.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

using Box = Eigen::AlignedBox3d;

/// A box for each connected piece.
std::vector<Box> boxesOfPieces(const TriangleMesh& mesh)
{
    DisjointSets pieces(mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles)
    {
        pieces.join(a, b);
        pieces.join(b, c);
    }
    std::vector<Box> boxes(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles)
    {
        for (const std::uint32_t corner : triangle)
        {
            boxes[pieces.find(corner)].extend(mesh.vertices[corner]);
        }
    }
    std::erase_if(boxes, [](const Box& box) { return box.isEmpty(); });
    return boxes;
}

bool areNear(const Box& a, const Box& b, double gap)
{
    return (a.min().array() < b.max().array() + gap).all() &&
           (b.min().array() < a.max().array() + gap).all();
}

/// Merges boxes that are near each other, along a sweep in x. Returns whether there were any.
bool mergeNear(std::vector<Box>& boxes, double gap)
{
    std::sort(boxes.begin(), boxes.end(),
              [](const Box& a, const Box& b) { return a.min().x() < b.min().x(); });
    std::vector<Box> merged;
    std::vector<std::size_t> open; // boxes of `merged` that may be near those to come
    bool any = false;
    for (const Box& box : boxes)
    {
        std::erase_if(open,
                      [&](std::size_t k) { return merged[k].max().x() + gap <= box.min().x(); });
        const auto near = std::find_if(open.begin(), open.end(),
                                       [&](std::size_t k) { return areNear(merged[k], box, gap); });
        if (near != open.end())
        {
            merged[*near].extend(box);
            any = true;
            continue;
        }
        open.push_back(merged.size());
        merged.push_back(box);
    }
    boxes = std::move(merged);
    return any;
}

} // namespace

std::vector<Box> separateBoxes(const TriangleMesh& mesh, double gap)
{
    std::vector<Box> boxes = boxesOfPieces(mesh);
    while (mergeNear(boxes, gap)) // a merged box may be near others
    {
    }
    return boxes;
}

std::vector<TriangleMesh> separateParts(const TriangleMesh& mesh, const std::vector<Box>& boxes)
{
    std::vector<TriangleMesh> parts(boxes.size());
    for (const auto& triangle : mesh.triangles)
    {
        const auto box = std::find_if(boxes.begin(), boxes.end(),
                                      [&](const Box& candidate)
                                      { return candidate.contains(mesh.vertices[triangle[0]]); });
        TriangleMesh& part = parts[static_cast<std::size_t>(box - boxes.begin())];
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        for (const std::uint32_t corner : triangle)
        {
            part.vertices.push_back(mesh.vertices[corner]);
        }
        part.triangles.push_back({first, first + 1, first + 2});
    }
    return parts;
}

} // namespace frostfill
