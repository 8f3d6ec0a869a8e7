// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Turns triangles until neighbours agree; turns the minority of each piece. Returns the number of
/// turned triangles. A one-sided surface keeps inconsistent edges.
std::size_t makeWindingConsistent(TriangleMesh& mesh);

/// Where more than two triangles meet at an edge of an even number, and their windings do not
/// cancel, turns triangles until they are wound in turn one way and the other around each such
/// edge, as those of solids that touch. Changes nothing if that is not possible at all of them.
/// Returns the number of turned triangles.
std::size_t alternateWindings(TriangleMesh& mesh);

/// Removes the triangles at edges whose two triangles makeWindingConsistent could not make agree,
/// where these edges are few: a knot in a scan, which leaves a small hole. A surface that is
/// one-sided as a whole, such as a Klein bottle, stays. Returns the number of removed triangles.
std::size_t cutWhereOneSided(TriangleMesh& mesh);

/// Turns whole pieces of a closed, consistent mesh: outer surfaces outwards, and cavities (surfaces
/// wholly inside another one) inwards, by the depth of nesting. `isOne`: it is known to be one
/// piece. Returns the number of turned
/// pieces.
std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne);

/// [#T] How many other pieces surround the one that a triangle is of.
[[nodiscard]] std::vector<std::size_t> depthsOfPieces(const TriangleMesh& mesh);

/// The triangles at an edge in the order of a turn about it.
[[nodiscard]] std::vector<EdgeUse> sortedAround(const TriangleMesh& mesh,
                                                std::span<const EdgeUse> uses);

/// Cuts the surface along edges where solid wedges touch: edges of four, six, ... triangles with
/// alternating windings. Each wedge gets its own vertices. Other edges stay as they are. Returns
/// the number of cut edges.
std::size_t separateTouchingEdges(TriangleMesh& mesh);

} // namespace frostfill
