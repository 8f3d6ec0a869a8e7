// SPDX-License-Identifier: MIT
#include "mesh/repair/loose_parts.hpp"

#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kNoPiece = static_cast<std::size_t>(-1);

/// [1] of the surface that may be removed as a part that encloses nothing. Larger: the object
/// itself goes, and what lies within it is filled.
constexpr double kMinPart = 1.0 / 3;

using Flags = std::vector<bool>; ///< [#T]

/// Removes the flagged triangles, unless they are too much of the surface.
std::size_t remove(TriangleMesh& mesh, const Flags& flags)
{
    double removed = 0;
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
        removed += flags[i] ? areaOf(mesh, mesh.triangles[i]) : 0;
    }
    if (!(removed < kMinPart * surfaceArea(mesh)))
    {
        return 0;
    }
    return eraseTriangles(mesh, [&](std::uint32_t triangle) { return flags[triangle]; });
}

/// Triangles that are connected over edges of exactly two.
DisjointSets findPatches(const TriangleMesh& mesh, const EdgeTable& edges)
{
    DisjointSets patches(mesh.triangles.size());
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2)
            {
                patches.join(uses[0].triangle, uses[1].triangle);
            }
        });
    return patches;
}

/// Which patches end in the open and hang on an edge of more than two.
Flags hangingPatches(const EdgeTable& edges, DisjointSets& patches, std::size_t count)
{
    Flags open(count, false);
    Flags hangs(count, false);
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (const EdgeUse& use : uses)
            {
                if (uses.size() != 2)
                {
                    (uses.size() == 1 ? open : hangs)[patches.find(use.triangle)] = true;
                }
            }
        });
    std::transform(open.begin(), open.end(), hangs.begin(), hangs.begin(),
                   [](bool a, bool b) { return a && b; });
    return hangs;
}

/// Takes back patches without which an edge is left with an odd number of triangles. Returns
/// whether there were any.
bool keepWhatCloses(const EdgeTable& edges, DisjointSets& patches, Flags& fins)
{
    bool changed = false;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto isLeft = [&](const EdgeUse& use)
            { return !fins[patches.find(use.triangle)]; };
            if (uses.size() <= 2 || std::count_if(uses.begin(), uses.end(), isLeft) % 2 == 0)
            {
                return;
            }
            for (const EdgeUse& use : uses)
            {
                changed = changed || !isLeft(use);
                fins[patches.find(use.triangle)] = false;
            }
        });
    return changed;
}

} // namespace

bool isEnvelope(double volume, double surface, const Eigen::AlignedBox3d& box)
{
    constexpr double kThinnest = 1e-6; // [1] below what any format's rounding makes of a flat sheet
    return !(std::abs(volume) > kThinnest * surface * box.diagonal().norm());
}

Sheets::Sheets(const TriangleMesh& mesh, const EdgeTable& edges, const std::vector<Rim>& rims)
    : pieceOf_(mesh.triangles.size(), kNoPiece)
{
    const auto pieces = connectedPieces(mesh, edges);
    std::vector<std::size_t> openEdges(pieces.size(), 0);
    std::vector<PieceSize> sizes(pieces.size());
    std::vector<Eigen::Vector3d> origins;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
        origins.push_back(mesh.vertices[mesh.triangles[pieces[piece][0]][0]]);
        for (const std::uint32_t triangle : pieces[piece])
        {
            pieceOf_[triangle] = piece;
            sizes[piece].add(mesh, mesh.triangles[triangle], origins[piece]);
        }
    }
    edges.forEach([&](std::span<const EdgeUse> uses)
                  { openEdges[pieceOf_[uses[0].triangle]] += uses.size() == 1 ? 1 : 0; });
    isSheet_ = std::vector<bool>(pieces.size(), false);
    for (const Rim& rim : rims)
    {
        const std::size_t piece = pieceOf_[edges.find(rim[0], rim[1])[0].triangle];
        sizes[piece].volume += volumeOfLid(mesh, rim, origins[piece]);
        openEdges[piece] -= rim.size();
        isSheet_[piece] = true; // perhaps: it is open
    }
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
        isSheet_[piece] = isSheet_[piece] && openEdges[piece] == 0 &&
                          isEnvelope(sizes[piece].volume, sizes[piece].area, sizes[piece].box);
    }
}

bool Sheets::has(std::uint32_t triangle) const
{
    return pieceOf_[triangle] != kNoPiece && isSheet_[pieceOf_[triangle]];
}

bool Sheets::areAll() const
{
    return std::find(isSheet_.begin(), isSheet_.end(), false) == isSheet_.end();
}

bool Sheets::areNone() const
{
    return std::find(isSheet_.begin(), isSheet_.end(), true) == isSheet_.end();
}

std::size_t dropSheets(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    const std::vector<Rim> rims = findRims(edges);
    if (rims.empty())
    {
        return 0;
    }
    const Sheets sheets(mesh, edges, rims);
    if (sheets.areAll() || sheets.areNone())
    {
        return 0;
    }
    return eraseTriangles(mesh, [&](std::uint32_t triangle) { return sheets.has(triangle); });
}

std::size_t dropFins(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    DisjointSets patches = findPatches(mesh, edges);
    Flags fins = hangingPatches(edges, patches, mesh.triangles.size());
    while (keepWhatCloses(edges, patches, fins))
    {
    }
    Flags flags(mesh.triangles.size(), false);
    for (std::uint32_t i = 0; i < flags.size(); ++i)
    {
        flags[i] = fins[patches.find(i)];
    }
    return remove(mesh, flags);
}

std::size_t dropOpenPieces(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    Flags isOpen(mesh.triangles.size(), false);
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 1)
            {
                isOpen[uses[0].triangle] = true;
            }
        });
    Flags flags(mesh.triangles.size(), false);
    for (const std::vector<std::uint32_t>& piece : connectedPieces(mesh, edges))
    {
        if (std::any_of(piece.begin(), piece.end(), [&](auto i) { return isOpen[i]; }))
        {
            std::for_each(piece.begin(), piece.end(), [&](auto i) { flags[i] = true; });
        }
    }
    return remove(mesh, flags);
}

} // namespace frostfill
