// SPDX-License-Identifier: MIT
#include "mesh/repair/orient_mesh.hpp"

#include "mesh/interior/winding_number.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/repair/triangle_shape.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kSamples = 64; // vertices of a piece to test against another piece
constexpr double kSurely = 0.02;     // [1] a winding number this close to 0 or 1 is certain

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

std::vector<Piece> describePieces(const TriangleMesh& mesh)
{
    std::vector<Piece> pieces;
    for (std::vector<std::uint32_t>& triangles : connectedPieces(mesh, EdgeTable(mesh)))
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

bool surrounds(const TriangleMesh& mesh, const Piece& outer, const Eigen::Vector3d& point)
{
    return outer.box.contains(point) && std::abs(windingNumber(mesh, outer.triangles, point)) > 0.5;
}

/// A vertex of `piece` on the other side of `other` than the rest of the piece.
std::optional<Eigen::Vector3d> findCrossing(const TriangleMesh& mesh, const Piece& piece,
                                            const Piece& other)
{
    bool someInside = false;
    bool someOutside = false;
    const std::size_t stride = 1 + piece.triangles.size() / kSamples;
    for (std::size_t i = 0; i < piece.triangles.size(); i += stride)
    {
        const Eigen::Vector3d& vertex = mesh.vertices[mesh.triangles[piece.triangles[i]][0]];
        const double winding =
            other.box.contains(vertex) ? std::abs(windingNumber(mesh, other.triangles, vertex)) : 0;
        someOutside = someOutside || winding < kSurely;
        someInside = someInside || winding > 1 - kSurely;
        if (someInside && someOutside)
        {
            return vertex;
        }
    }
    return std::nullopt;
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

std::size_t turnPiecesOutward(TriangleMesh& mesh)
{
    const std::vector<Piece> pieces = describePieces(mesh);
    std::vector<bool> turns(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        const Eigen::Vector3d& point = mesh.vertices[mesh.triangles[pieces[i].triangles[0]][0]];
        std::size_t depth = 0;
        for (std::size_t j = 0; j < pieces.size(); ++j)
        {
            if (j != i && surrounds(mesh, pieces[j], point))
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

std::optional<Eigen::Vector3d> findCrossingPieces(const TriangleMesh& mesh)
{
    const std::vector<Piece> pieces = describePieces(mesh);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        for (std::size_t j = 0; j < pieces.size(); ++j)
        {
            if (i != j && pieces[i].box.intersects(pieces[j].box))
            {
                if (const auto place = findCrossing(mesh, pieces[i], pieces[j]))
                {
                    return place;
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace frostfill
