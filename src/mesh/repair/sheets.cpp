// SPDX-License-Identifier: MIT
#include "mesh/repair/sheets.hpp"

#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kNoPiece = static_cast<std::size_t>(-1);

/// Of a tetrahedron.
double volumeOf(const Eigen::Vector3d& origin, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c)
{
    return (a - origin).dot((b - origin).cross(c - origin)) / 6;
}

/// Of a cone from the rim's middle: any lid over a flat rim adds as much.
double volumeOfLid(const TriangleMesh& mesh, const Rim& rim, const Eigen::Vector3d& origin)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t vertex : rim)
    {
        middle += (mesh.vertices[vertex] - origin) / static_cast<double>(rim.size());
    }
    double sum = 0;
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        sum += volumeOf(origin, mesh.vertices[rim[i]], mesh.vertices[rim[(i + 1) % rim.size()]],
                        origin + middle);
    }
    return sum;
}

bool isThin(const TriangleMesh& mesh, const std::vector<std::uint32_t>& piece,
            const Eigen::Vector3d& origin, double volumeOfLids)
{
    double volume = volumeOfLids;
    double surface = 0;
    Eigen::AlignedBox3d box;
    for (const std::uint32_t triangle : piece)
    {
        const Triangle& t = mesh.triangles[triangle];
        volume += volumeOf(origin, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
        surface += areaOf(mesh, t);
        for (const std::uint32_t corner : t)
        {
            box.extend(mesh.vertices[corner]);
        }
    }
    return isEnvelope(volume, surface, box);
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
    std::vector<double> volumes(pieces.size(), 0);
    std::vector<Eigen::Vector3d> origins;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
        for (const std::uint32_t triangle : pieces[piece])
        {
            pieceOf_[triangle] = piece;
        }
        origins.push_back(mesh.vertices[mesh.triangles[pieces[piece][0]][0]]);
    }
    edges.forEach([&](std::span<const EdgeUse> uses)
                  { openEdges[pieceOf_[uses[0].triangle]] += uses.size() == 1 ? 1 : 0; });
    isSheet_ = std::vector<bool>(pieces.size(), false);
    for (const Rim& rim : rims)
    {
        const std::size_t piece = pieceOf_[edges.find(rim[0], rim[1])[0].triangle];
        volumes[piece] += volumeOfLid(mesh, rim, origins[piece]);
        openEdges[piece] -= rim.size();
        isSheet_[piece] = true; // perhaps: it is open
    }
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
        isSheet_[piece] = isSheet_[piece] && openEdges[piece] == 0 &&
                          isThin(mesh, pieces[piece], origins[piece], volumes[piece]);
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
