// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/mesh_shading.hpp"

namespace frostfill
{

/// Marks creases that hang together with few others: where a scan is rough, single edges are bent
/// as much as those of a box. `positions` are the mesh's vertices in unit space.
void findStrayCreases(const std::vector<glm::vec3>& positions, ShadedMesh& shaded);

/// What ShadedMesh::creaseDistances holds. Where triangles are smaller than a line is wide, the
/// line runs over more than those on either side of its edge, which have to know how far it is.
[[nodiscard]] std::vector<std::array<float, 3>>
distancesFromCreases(const TriangleMesh& mesh, const std::vector<glm::vec3>& positions,
                     const std::vector<ShadedMesh::Edge>& edges);

} // namespace frostfill
