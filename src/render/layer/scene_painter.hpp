// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/passes/mesh_pass.hpp"
#include "render/passes/sphere_pass.hpp"
#include "render/picture/drawn_shell.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/picture/studio.hpp"

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
    /// `shell` is what is drawn of the mesh; `samplePositions` are those of the framebuffers that
    /// are painted [pixel]; one for no multisampling.
    ScenePainter(const GlFunctions& gl, const TriangleMesh& mesh, const DrawnShell& shell,
                 const RenderSettings& settings, const Framing& framing,
                 std::span<const glm::vec2> samplePositions);

    void lookFrom(const Framing& framing);
    /// Shows another mesh as the shell from now on, before the next lookFrom().
    void setShell(const DrawnShell& shell);
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
    [[nodiscard]] bool paintsOccluders() const { return !variant_.cutaway; }
    void paintShell();
    /// paintShell with the triangles that may be seen in one of the parts only.
    void paintShell(std::span<const PicturePart> parts);

    /// Returns the spheres at rest as occluders; null without ambient occlusion.
    [[nodiscard]] SphereOcclusion* sphereOcclusion()
    {
        return sphereOcclusion_ ? &*sphereOcclusion_ : nullptr;
    }

    [[nodiscard]] const SphereUniforms& uniforms() const { return uniforms_; }
    [[nodiscard]] const ShaderVariant& variant() const { return variant_; }

    /// Adds spheres to a finished picture as if they had been painted before the shell. `parts` are
    /// where they may be seen.
    void addSpheres(std::span<const SphereInstance> spheres, std::span<const PicturePart> parts);
    /// addSpheres marks what it has painted with a new number each time. When so many more are too
    /// many, resetStencil has to be called on every framebuffer that it was used on, then
    /// restartStencil.
    [[nodiscard]] bool stencilIsFull(int wanted) const { return stencilValue_ + wanted > 255; }
    void resetStencil();
    void restartStencil() { stencilValue_ = 0; }

private:
    void findBounds();
    void paintSpheres(std::span<const SphereInstance> spheres, const SpherePass& pass);
    void setView(const Framing& framing);

    const GlFunctions& gl_;
    RenderSettings settings_;
    ShaderVariant variant_;
    std::optional<Studio> studio_;
    std::optional<SphereOcclusion> sphereOcclusion_;
    std::unique_ptr<GroundPass> ground_;
    std::vector<SphereLight> lights_;
    Framing framing_;
    SphereUniforms uniforms_;
    SpherePass spherePass_;                     ///< of whole spheres
    std::optional<SpherePass> cutSpherePass_;   ///< of those that the cutaway leaves a part of
    std::optional<SpherePass> plainSpherePass_; ///< without multisampling, for occluders
    MeshPass meshPass_;
    SphereBuffer spheres_;
    ShadedMesh shaded_;
    std::unique_ptr<MeshBuffer> shell_;
    std::vector<ProjectedSphere> bounds_; ///< [#T] around the triangles of the shell
    std::vector<std::uint32_t> chosen_;   ///< of them, for a part
    std::vector<SphereInstance> shrunk_;
    std::vector<SphereInstance> whole_; ///< beside a cutaway
    std::vector<SphereInstance> cut_;   ///< by it
    float occluderShrink_ = 0;          ///< [pixel]
    int stencilValue_ = 0;
};

} // namespace frostfill
