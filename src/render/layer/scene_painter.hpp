// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"
#include "render/passes/mesh_pass.hpp"
#include "render/passes/sphere_pass.hpp"
#include "render/picture/picture_backend.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_occlusion.hpp"

#include <frostfill/renderer.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// With several samples a pixel Mesa leaves some of them out along the inside of a scissor
/// rectangle's edges and draws some along the outside, so that it has to be larger than what is
/// used of it, and what is not to be drawn to has to be still further away. [pixel]
inline constexpr int kScissorMargin = 2;

/// A part of the picture, down to a window depth. It may reach beyond the picture.
struct PicturePart
{
    PixelRectangle pixels;
    float furthest = 2;
};

/// Paints parts of the scene into the framebuffer that is bound. The order that makes a picture is
/// clear, spheres, shell.
class ScenePainter
{
public:
    /// `viewpoint`, `shell` and `occlusion` must stay; that is null without ambient occlusion.
    /// `triangles` is their number in the mesh. `samplePositions` are those of the framebuffers
    /// that are painted [pixel]; one for no multisampling.
    ScenePainter(const GlFunctions& gl, const Viewpoint& viewpoint, const DrawnShell& shell,
                 std::size_t triangles, SphereOcclusion* occlusion,
                 std::span<const glm::vec2> samplePositions);

    /// The camera has moved.
    void useFraming();
    /// The mesh of the shell has changed; before the next useFraming().
    void useShell();
    /// Takes the states of these triangles of the shell. Returns the part of the picture where they
    /// are seen.
    PixelRectangle setPolygons(std::span<const std::uint32_t> changed,
                               std::span<const PolygonState> states);

    void clear();
    /// The studio's, where the camera looks down at it.
    void paintGround();
    /// Everything that is painted from now on, clearing too, is confined to the rectangle.
    void confine(const PixelRectangle& part);
    void endConfinement();

    void paintSpheres(std::span<const SphereInstance> spheres);
    /// Depth only, and only where a sphere covers a whole pixel and all around it; for a
    /// framebuffer without multisampling. What is behind these depths is hidden at every sample.
    /// Only for paintsOccluders().
    void paintOccluders(std::span<const SphereInstance> spheres, const SphereProjector& projector);
    /// What a cut leaves of a small sphere may be nearer than what it leaves of the full one.
    [[nodiscard]] bool paintsOccluders() const { return !viewpoint_.variant().cutaway; }
    void paintShell();
    /// paintShell with the triangles that may be seen in one of the parts only.
    void paintShell(std::span<const PicturePart> parts);

    /// Adds spheres to a finished picture as if they had been painted before the shell. `parts` are
    /// where they may be seen. The stencil is 0 everywhere, before and after.
    void addSpheres(std::span<const SphereInstance> spheres, std::span<const PicturePart> parts);

private:
    void findBounds();
    void paintSpheres(std::span<const SphereInstance> spheres, const SpherePass& pass);

    const GlFunctions& gl_;
    const Viewpoint& viewpoint_;
    const DrawnShell& drawnShell_;
    SphereOcclusion* sphereOcclusion_;
    std::unique_ptr<GroundPass> ground_;
    std::vector<SphereLight> lights_;
    SpherePass spherePass_;                     ///< of whole spheres
    std::optional<SpherePass> cutSpherePass_;   ///< of those that the cutaway leaves a part of
    std::optional<SpherePass> plainSpherePass_; ///< without multisampling, for occluders
    MeshPass meshPass_;
    SphereBuffer spheres_;
    std::unique_ptr<MeshBuffer> shell_;
    std::vector<ProjectedSphere> bounds_; ///< [#T] around the triangles of the shell
    std::vector<std::uint32_t> chosen_;   ///< of them, for a part
    std::vector<SphereInstance> shrunk_;
    std::vector<SphereInstance> whole_; ///< beside a cutaway
    std::vector<SphereInstance> cut_;   ///< by it
    float occluderShrink_ = 0;          ///< [pixel]
};

} // namespace frostfill
