// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/mesh_shading.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The vertices of a mesh, each once for every normal that it has: a camera looks at a vertex of a
/// smooth surface once and not in every triangle. They are in the order of the triangles, so that
/// those of a triangle are found where the one before had its own.
struct ShellVertices
{
    explicit ShellVertices(const ShadedMesh& mesh);

    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;                      ///< [positions]
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< [#T] indices into positions
};

} // namespace frostfill
