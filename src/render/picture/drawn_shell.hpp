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
    DrawnShell(const TriangleMesh& mesh, const RenderSettings& settings, const Framing& framing);

    /// Fits the mesh to a camera, whatever cameras came before. Returns whether it has changed.
    bool lookFrom(const Framing& framing);

    [[nodiscard]] const TriangleMesh& mesh() const { return shell_.mesh; }
    /// Returns the mesh with normals and edges, as shadeMesh() makes them.
    [[nodiscard]] ShadedMesh shaded(const Framing& framing, bool fadingLines) const;
    /// Takes the states of the true triangles; those beyond the span's end are active. Returns
    /// which triangles of this mesh have changed, until the next call.
    std::span<const std::uint32_t> follow(std::span<const PolygonState> polygons);
    /// [#T] of this mesh.
    [[nodiscard]] std::span<const PolygonState> states() const { return states_; }

private:
    void use(SimplifiedShell shell);
    [[nodiscard]] double wantedDistance(const Framing& framing) const;

    TriangleMesh dense_;  ///< if it may be drawn as one of fewer triangles
    int height_;          ///< of the picture [pixel]
    double distance_ = 0; ///< from the true mesh to which `shell_` was made [mesh unit]
    SimplifiedShell shell_;
    std::vector<PolygonState> states_;     ///< [#T]
    std::vector<PolygonState> simplified_; ///< [#T] if the mesh is not the true one
    std::vector<std::uint32_t> changed_;
};

} // namespace frostfill
