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

/// Triangles in unit space, with what follows from their shape alone.
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

    std::vector<glm::vec3> positions;                    ///< [#V]
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< [#T] indices into positions
    std::vector<std::array<glm::vec3, 3>> normals;       ///< [#T x 3] smooth but across creases
    std::vector<glm::vec3> faceNormals;                  ///< [#T] unit, or zero
    std::vector<Edge> edges;
    /// [#T x 3] from each corner to the nearest crease, 0..1 for 0..kCreaseReach; empty if there is
    /// none.
    std::vector<std::array<float, 3>> creaseDistances;

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

/// Marks creases that hang together with few others: where a scan is rough, single edges are bent
/// as much as those of a box. `positions` are the mesh's vertices in unit space.
void findStrayCreases(const std::vector<glm::vec3>& positions, ShadedMesh& shaded);

/// What ShadedMesh::creaseDistances holds. Where triangles are smaller than a line is wide, the
/// line runs over more than those on either side of its edge, which have to know how far it is.
[[nodiscard]] std::vector<std::array<float, 3>>
distancesFromCreases(const TriangleMesh& mesh, const std::vector<glm::vec3>& positions,
                     const std::vector<ShadedMesh::Edge>& edges);

} // namespace frostfill
