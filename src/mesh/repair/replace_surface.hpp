// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// How far a skin lies around the mesh, over alpha. [1]
inline constexpr double kOffsetOverAlpha = 1.0 / 30;

/// Replaces any triangles by a skin around them (makeSkin) and adds a sentence to the repairs.
/// `alpha` 0: a fiftieth of the diagonal of the mesh's box. Throws Error badData if the skin
/// encloses little more than itself, too.
void wrapMesh(TriangleMesh& mesh, double alpha, std::string_view name,
              std::vector<std::string>& repairs);

/// Replaces a closed mesh by the boundary of its interior (makeUnion) and adds a sentence to the
/// repairs. A mesh that does not meet itself stays as it is.
void unite(TriangleMesh& mesh, std::string_view name, std::vector<std::string>& repairs);

} // namespace frostfill
