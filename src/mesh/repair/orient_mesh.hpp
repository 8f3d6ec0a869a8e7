// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Turns triangles until neighbours agree; turns the minority of each piece. Returns the number of
/// turned triangles. A one-sided surface keeps inconsistent edges.
std::size_t makeWindingConsistent(TriangleMesh& mesh);

/// Turns whole pieces of a closed, consistent mesh: outer surfaces outwards, and cavities (surfaces
/// wholly inside another one) inwards, by the depth of nesting. `isOne`: it is known to be one
/// piece. Returns the number of turned
/// pieces.
std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne);

} // namespace frostfill
