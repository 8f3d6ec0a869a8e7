// SPDX-License-Identifier: MIT
#include "mesh/repair/orient_mesh.hpp"

#include "mesh/interior/winding_number.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

constexpr std::size_t kSamples = 64; // triangles of a piece to test against another piece

void turn(Triangle& t)
{
    std::swap(t[1], t[2]);
}

struct Piece
{
    std::vector<std::uint32_t> triangles;
    Eigen::AlignedBox3d box;
    double volume = 0;
};

/// All triangles, as one piece.
std::vector<std::vector<std::uint32_t>> onePiece(const TriangleMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> pieces = {
        std::vector<std::uint32_t>(mesh.triangles.size())};
    std::iota(pieces[0].begin(), pieces[0].end(), std::uint32_t{0});
    return pieces;
}

std::vector<Piece> describePieces(const TriangleMesh& mesh, bool isOne)
{
    std::vector<Piece> pieces;
    for (std::vector<std::uint32_t>& triangles :
         isOne ? onePiece(mesh) : connectedPieces(mesh, EdgeTable(mesh)))
    {
        Piece piece;
        const Eigen::Vector3d origin = mesh.vertices[mesh.triangles[triangles[0]][0]];
        for (const std::uint32_t triangle : triangles)
        {
            std::array<Eigen::Vector3d, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
            {
                corners[i] = mesh.vertices[mesh.triangles[triangle][i]];
                piece.box.extend(corners[i]);
            }
            piece.volume +=
                (corners[0] - origin).dot((corners[1] - origin).cross(corners[2] - origin)) / 6;
        }
        piece.triangles = std::move(triangles);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Whether the whole of a piece lies within another one. A piece that passes through it does not.
bool surrounds(const TriangleMesh& mesh, const Piece& outer, const Piece& piece)
{
    if (!outer.box.contains(piece.box))
    {
        return false;
    }
    const std::size_t stride = 1 + piece.triangles.size() / kSamples;
    for (std::size_t i = 0; i < piece.triangles.size(); i += stride)
    {
        const Triangle& t = mesh.triangles[piece.triangles[i]];
        const Eigen::Vector3d middle =
            (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
        for (const Eigen::Vector3d& point : {mesh.vertices[t[0]], middle})
        {
            if (std::abs(windingNumber(mesh, outer.triangles, point)) < kInsideFrom)
            {
                return false;
            }
        }
    }
    return true;
}

} // namespace

std::size_t makeWindingConsistent(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    struct Link
    {
        std::uint32_t triangle;
        bool agrees;
    };
    std::vector<std::vector<Link>> links(mesh.triangles.size());
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() != 2)
            {
                return;
            }
            const bool agrees = uses[0].forward != uses[1].forward;
            links[uses[0].triangle].push_back({uses[1].triangle, agrees});
            links[uses[1].triangle].push_back({uses[0].triangle, agrees});
        });

    std::size_t turned = 0;
    std::vector<bool> seen(mesh.triangles.size(), false);
    std::vector<bool> turns(mesh.triangles.size(), false);
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed)
    {
        if (seen[seed])
        {
            continue;
        }
        std::vector<std::uint32_t> flood = {seed};
        seen[seed] = true;
        std::size_t against = 0;
        for (std::size_t i = 0; i < flood.size(); ++i)
        {
            for (const Link& link : links[flood[i]])
            {
                if (!seen[link.triangle])
                {
                    seen[link.triangle] = true;
                    turns[link.triangle] = turns[flood[i]] == link.agrees;
                    against += turns[link.triangle] ? 1U : 0U;
                    flood.push_back(link.triangle);
                }
            }
        }
        const bool turnOthers = 2 * against > flood.size();
        for (const std::uint32_t triangle : flood)
        {
            if (turns[triangle] != turnOthers)
            {
                turn(mesh.triangles[triangle]);
                ++turned;
            }
        }
    }
    return turned;
}

std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne)
{
    const std::vector<Piece> pieces = describePieces(mesh, isOne);
    std::vector<bool> turns(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        std::size_t depth = 0;
        for (std::size_t j = 0; j < pieces.size(); ++j)
        {
            if (j != i && surrounds(mesh, pieces[j], pieces[i]))
            {
                ++depth;
            }
        }
        turns[i] = (depth % 2 == 0) != (pieces[i].volume > 0);
    }
    std::size_t turned = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        if (turns[i])
        {
            ++turned;
            for (const std::uint32_t triangle : pieces[i].triangles)
            {
                turn(mesh.triangles[triangle]);
            }
        }
    }
    return turned;
}

} // namespace frostfill
