// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/rims.hpp"

namespace frostfill
{

/// Which triangles are of sheets: open pieces that lids make envelopes without volume.
class Sheets
{
public:
    /// The rims are all that the mesh has.
    Sheets(const TriangleMesh& mesh, const EdgeTable& edges, const std::vector<Rim>& rims);

    [[nodiscard]] bool has(std::uint32_t triangle) const;
    [[nodiscard]] bool areAll() const;
    [[nodiscard]] bool areNone() const;

private:
    std::vector<std::size_t> pieceOf_; ///< [#T]
    std::vector<bool> isSheet_;        ///< [#pieces]
};

/// Whether a piece with lids is a mere envelope: its volume over its area times its size.
[[nodiscard]] bool isEnvelope(double volume, double surface, const Eigen::AlignedBox3d& box);

/// Removes open pieces that would enclose nothing with lids, sheets, from beside pieces that are
/// none. Returns the number of removed triangles; 0 if there is nothing but sheets.
std::size_t dropSheets(TriangleMesh& mesh);

/// Removes fins: parts of a surface that end in the open and hang on the rest by edges of three
/// triangles or more, where the rest closes without them. They enclose nothing. Returns the number
/// of removed triangles; 0 if they would be most of the surface.
std::size_t dropFins(TriangleMesh& mesh);

/// Removes open pieces that no lid of a small hole closes, beside closed pieces with most of the
/// surface. Returns the number of removed triangles.
std::size_t dropOpenPieces(TriangleMesh& mesh);

} // namespace frostfill
