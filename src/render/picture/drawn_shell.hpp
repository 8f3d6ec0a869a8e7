// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/mesh_shading.hpp"
#include "shell/simplified_shell.hpp"

#include <frostfill/renderer.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The mesh that pictures show as the shell: the true one or, if that has more than
/// kShellTriangles, one of fewer triangles within about half a pixel of it.
class DrawnShell
{
public:
    /// `fadingLines`: see shadeMesh().
    DrawnShell(const TriangleMesh& mesh, const RenderSettings& settings, const Framing& framing,
               bool fadingLines);

    /// Fits the mesh and its edges to a camera, whatever cameras came before. Returns whether the
    /// mesh has changed.
    bool lookFrom(const Framing& framing);

    [[nodiscard]] const TriangleMesh& mesh() const { return shell_.mesh; }
    /// Returns the mesh as shadeMesh() makes it, without triangles in pictures without a shell.
    [[nodiscard]] const ShadedMesh& shaded() const { return shaded_; }
    /// [#T] as edgeStrengths() gives them for the camera.
    [[nodiscard]] const std::vector<std::array<std::uint8_t, 3>>& edges() const { return edges_; }
    /// Takes the states of the true triangles; those beyond the span's end are active. Returns
    /// which triangles of this mesh have changed, until the next call.
    std::span<const std::uint32_t> follow(std::span<const PolygonState> polygons);
    /// [#T] of this mesh.
    [[nodiscard]] std::span<const PolygonState> states() const { return states_; }

private:
    void use(SimplifiedShell shell, const Framing& framing);
    [[nodiscard]] double wantedDistance(const Framing& framing) const;

    TriangleMesh dense_; ///< if it may be drawn as one of fewer triangles
    int height_;         ///< of the picture [pixel]
    bool isSeen_;        ///< the picture shows it
    bool fadingLines_;
    double distance_ = 0; ///< from the true mesh to which `shell_` was made [mesh unit]
    SimplifiedShell shell_;
    ShadedMesh shaded_;
    std::vector<std::array<std::uint8_t, 3>> edges_;
    std::vector<PolygonState> states_;     ///< [#T]
    std::vector<PolygonState> simplified_; ///< [#T] if the mesh is not the true one
    std::vector<std::uint32_t> changed_;
};

} // namespace frostfill
