// SPDX-License-Identifier: MIT
#include "bed/wall_holes.hpp"

#include "bed/hole_cutter.hpp"

#include <numbers>
#include <utility>

namespace frostfill
{
namespace
{

/// Turns of the corners about the axis that are tried where they come too near to edges of walls.
constexpr int kTurns = 5;

std::vector<std::uint8_t> patchesOf(const Bed& bed)
{
    std::vector<std::uint8_t> patches;
    for (std::size_t t = 0; t < bed.mesh().triangles.size(); ++t)
    {
        patches.push_back(static_cast<std::uint8_t>(bed.patch(t)));
    }
    return patches;
}

} // namespace

WallHoles::WallHoles(const Bed& bed, BedLinks& links)
{
    const std::vector<std::uint8_t> patches = patchesOf(bed);
    WallMesh walls(bed.surface(), patches);
    dropWhatDoesNotFit(bed, links);
    // A place that is flattened after all may take the room of a bridge, whose hole then closes.
    for (std::size_t open = links.bridgedWalls; open > 0;)
    {
        walls = WallMesh(bed.surface(), patches);
        const std::size_t cut = cutAll(bed, links, walls);
        dropWhatDoesNotFit(bed, links);
        open = links.bridgedWalls == cut ? 0 : links.bridgedWalls;
    }
    for (std::uint32_t k = 0; k < walls.size(); ++k)
    {
        const WallMesh::Piece& piece = walls[k];
        if (!piece.isHole)
        {
            triangles_[patches[piece.plane]].push_back(
                {inSinglePrecision(walls.vertex(piece.corner[0])),
                 inSinglePrecision(walls.vertex(piece.corner[1])),
                 inSinglePrecision(walls.vertex(piece.corner[2]))});
        }
    }
}

std::size_t WallHoles::cutAll(const Bed& bed, BedLinks& links, WallMesh& walls)
{
    edges_.assign(links.links.size(), {});
    std::size_t holes = 0;
    for (std::size_t k = 0; k < links.links.size(); ++k)
    {
        BedLink& link = links.links[k];
        if (link.second != BedLink::kWall || link.bridge == 0)
        {
            continue;
        }
        std::vector<std::vector<std::uint32_t>> edges;
        for (int turn = 0; turn < kTurns && edges.empty(); ++turn)
        {
            link.turn = 2 * std::numbers::pi * turn / kTurns / cornersOf(bed, link);
            edges = HoleCutter(bed, walls, link).cut();
        }
        link.bridge = edges.empty() ? 0 : link.bridge;
        holes += edges.empty() ? 0 : 1;
        for (const std::vector<std::uint32_t>& edge : edges)
        {
            std::vector<Eigen::Vector3f>& places = edges_[k].emplace_back();
            for (const std::uint32_t v : edge)
            {
                places.push_back(inSinglePrecision(walls.vertex(v)));
            }
        }
    }
    return holes;
}

void WallHoles::addBridge(const Bed& bed, const BedLink& link, std::uint32_t number,
                          std::vector<StlTriangle>& triangles) const
{
    const auto& edges = edges_[number];
    const auto corners = static_cast<std::uint32_t>(edges.size());
    for (std::uint32_t k = 0; k < corners; ++k)
    {
        const std::uint32_t next = (k + 1) % corners;
        const Eigen::Vector3f a = cornerInWorld(bed, link, link.first, k, corners);
        const Eigen::Vector3f b = cornerInWorld(bed, link, link.first, next, corners);
        for (std::size_t place = 0; place < edges[k].size(); ++place)
        {
            const bool isLast = place + 1 == edges[k].size();
            triangles.push_back(
                {a, edges[k][place], isLast ? edges[next].front() : edges[k][place + 1]});
        }
        triangles.push_back({a, edges[next].front(), b});
    }
}

} // namespace frostfill
