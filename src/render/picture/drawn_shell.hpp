// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/mesh_shading.hpp"
#include "shell/simplified_shell.hpp"

#include <frostfill/renderer.hpp>

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
    /// Returns the states of its triangles from those of the true ones, until the next call.
    [[nodiscard]] std::span<const PolygonState> states(std::span<const PolygonState> polygons);

private:
    [[nodiscard]] double wantedDistance(const Framing& framing) const;

    TriangleMesh dense_;  ///< if it may be drawn as one of fewer triangles
    int height_;          ///< of the picture [pixel]
    double distance_ = 0; ///< from the true mesh to which `shell_` was made [mesh unit]
    SimplifiedShell shell_;
    std::vector<PolygonState> states_;
};

} // namespace frostfill
