// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Triangles in unit space, with what follows from their shape alone.
struct ShadedMesh
{
    /// A triangle on either side of an edge; `kNone` at a rim.
    struct Edge
    {
        static constexpr std::uint32_t kNone = 0xffffffffU;
        std::array<std::uint32_t, 2> triangles{kNone, kNone};
        std::array<std::uint8_t, 2> corners{}; ///< the corner opposite the edge in each triangle
        std::uint8_t crease =
            0; ///< how strongly it is drawn whatever the view; 0 where it is smooth
    };

    std::vector<std::array<glm::vec3, 3>> corners; ///< [#T x 3] positions
    std::vector<std::array<glm::vec3, 3>> normals; ///< [#T x 3] smooth but across creases
    std::vector<glm::vec3> faceNormals;            ///< [#T] unit, or zero
    std::vector<Edge> edges;
};

/// `positions` are the mesh's vertices in unit space.
[[nodiscard]] ShadedMesh shadeMesh(const TriangleMesh& mesh,
                                   const std::vector<glm::vec3>& positions);

/// How strongly each edge of each triangle is drawn, 0..255, in the order of the opposite corners:
/// rims and the outline seen from `eye` in full, creases the more the sharper they are, all others
/// faintly.
/// Without perspective `eye` is the direction towards the viewer.
[[nodiscard]] std::vector<std::array<std::uint8_t, 3>>
edgeStrengths(const ShadedMesh& mesh, const glm::vec3& eye, bool orthographic);

} // namespace frostfill
