// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/numbers.hpp"

#include <frostfill/mesh.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Triangles in unit space, with what follows from their shape alone. A vertex of the mesh is here
/// once for every normal that it has: where the surface is smooth, a camera looks at it once and
/// not in every triangle.
struct ShadedMesh
{
    /// A triangle on either side of an edge; `kNone` at a rim.
    struct Edge
    {
        static constexpr std::uint32_t kNone = 0xffffffffU;
        std::array<std::uint32_t, 2> triangles{kNone, kNone};
        std::array<std::uint8_t, 2> corners{}; ///< the corner opposite the edge in each triangle
        std::array<std::uint32_t, 2> ends{};   ///< vertices of the mesh
        std::uint8_t crease =
            0;              ///< how strongly it is drawn whatever the view; 0 where it is smooth
        bool stray = false; ///< a crease too short to be one: noise of a scan
    };

    std::vector<glm::vec3> positions;                    ///< of its vertices
    std::vector<glm::vec3> normals;                      ///< [positions] smooth but across creases
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< [#T] indices into positions
    std::vector<glm::vec3> faceNormals;                  ///< [#T] unit, or zero
    std::vector<Edge> edges;
    /// [positions] from the nearest crease, 0..1 for 0..kCreaseReach; empty if there is none.
    std::vector<float> creaseDistances;

    [[nodiscard]] std::array<glm::vec3, 3> corners(std::size_t triangle) const
    {
        const auto& [a, b, c] = triangles[triangle];
        return {positions[a], positions[b], positions[c]};
    }
};

/// How far from a crease triangles know of it [unit space]: some pixels in a picture of usual size.
inline constexpr float kCreaseReach = 0.02F;

/// What a line of the shell is, as edgeStrengths gives it.
namespace line_strength
{
inline constexpr std::uint8_t kPlain = shading::kPlainEdge;
inline constexpr std::uint8_t kStrong = shading::kStrongEdge;
inline constexpr std::uint8_t kOutline = shading::kOutlineEdge;
} // namespace line_strength

/// `positions` are the mesh's vertices in unit space. Without `fadingLines` no crease is stray, and
/// triangles know of their own edges only. `trueNormals` are those of the surface that a simplified
/// mesh stands for [#T], else empty.
[[nodiscard]] ShadedMesh shadeMesh(const TriangleMesh& mesh,
                                   const std::vector<glm::vec3>& positions, bool fadingLines = true,
                                   std::span<const glm::vec3> trueNormals = {});

/// What each edge of each triangle is, a line_strength, in the order of the opposite corners: rims
/// and the outline seen from `eye`, creases the stronger the sharper they are, all others plain.
/// Without perspective `eye` is the direction towards the viewer.
[[nodiscard]] std::vector<std::array<std::uint8_t, 3>>
edgeStrengths(const ShadedMesh& mesh, const glm::vec3& eye, bool orthographic);

} // namespace frostfill
