// SPDX-License-Identifier: MIT
#include "mesh/repair/sheets.hpp"

#include "mesh/repair/components.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kNoPiece = static_cast<std::size_t>(-1);

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

} // namespace frostfill
