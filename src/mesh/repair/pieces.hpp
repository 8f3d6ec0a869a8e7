// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/connectivity.hpp"
#include "mesh/triangle_shape.hpp"

#include <map>

namespace frostfill
{

/// Directed edges: from a vertex to the next ones.
using NextVertices = std::multimap<std::uint32_t, std::uint32_t>;
using Rim = std::vector<std::uint32_t>; ///< vertices around a hole

/// The rims, in the direction of the lids, each without repeated vertices. A path that does not
/// close, because it ends at an edge of three triangles, is no rim.
[[nodiscard]] std::vector<Rim> findRims(const EdgeTable& edges);

/// The closed paths along these edges, each without repeated vertices. Where as many edges enter
/// each vertex as leave it, all edges are in one.
[[nodiscard]] std::vector<Rim> closedPaths(NextVertices next);

/// Mean of the vertices.
[[nodiscard]] Eigen::Vector3d middleOf(const TriangleMesh& mesh, const Rim& rim);

/// Of triangles that are added one after the other.
struct PieceSize
{
    double volume = 0; ///< [unit^3] signed, of the cones from a point to them
    double area = 0;   ///< [unit^2]
    Eigen::AlignedBox3d box;

    void add(const TriangleMesh& mesh, const Triangle& t, const Eigen::Vector3d& origin);
    /// Whether a piece of this size, with its lids, is a mere envelope.
    [[nodiscard]] bool isEnvelope() const;
};

/// Triangles that shared edges connect.
struct Piece
{
    std::vector<std::uint32_t> triangles;
    PieceSize size;              ///< with lids, cones from the middles of the rims
    std::size_t openEdges = 0;   ///< of one triangle
    std::size_t edgesOfRims = 0; ///< those of them that are of rims
    double lids = 0;             ///< [unit^2] area of the lids

    /// Whether lids make it an envelope without volume.
    [[nodiscard]] bool isSheet() const
    {
        return edgesOfRims > 0 && openEdges == edgesOfRims && size.isEnvelope();
    }
};

/// The pieces of a mesh, in the order of their first triangles. Triangles that repeat a corner
/// belong to none.
class Pieces
{
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    Pieces(const TriangleMesh& mesh, const EdgeTable& edges);

    /// Removes the triangles of the pieces that fulfil a condition. Returns how many.
    template <class IsGone>
    std::size_t erase(TriangleMesh& mesh, IsGone&& isGone) const
    {
        return eraseTriangles(mesh, [&](std::uint32_t triangle)
                              { return of[triangle] != kNone && isGone(all[of[triangle]]); });
    }

    std::vector<Piece> all;
    std::vector<std::size_t> of; ///< [#T]
};

} // namespace frostfill
