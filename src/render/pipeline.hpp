// SPDX-License-Identifier: MIT
#pragma once

#include "colour_scale.hpp"
#include "context.hpp"
#include "cutaway_planes.hpp"
#include "framebuffer.hpp"
#include "framing.hpp"
#include "legend.hpp"
#include "mesh_pass.hpp"
#include "sphere_pass.hpp"
#include "surface_pass.hpp"

#include <frostfill/renderer.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Everything that draws on OpenGL's side: the context, what is uploaded to it, and the passes in
/// their order. The public Renderer adds the text and the clock.
class Pipeline
{
public:
    Pipeline(const TriangleMesh& mesh, const RenderSettings& settings);
    ~Pipeline();
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    /// Turns the camera about the up axis, from where the settings have it [degree].
    void turn(double degrees);
    /// Draws and waits until it is done.
    void draw(const Snapshot& snapshot);
    /// RGB, top row first.
    void readColour(Image& image);
    /// Window depth in 0..1, top row first; for samples == 1.
    [[nodiscard]] std::vector<float> readDepth();

    /// What is seen of the spheres, in a picture of any size with the same view.
    void drawSurfaces(const Snapshot& snapshot, const PictureSize& size, Surfaces& surfaces);

    [[nodiscard]] const Framing& framing() const { return framing_; }
    [[nodiscard]] const SphereColours& colours() const { return colours_; }
    [[nodiscard]] const Legend& legend() const { return legend_; }
    [[nodiscard]] const std::string& description() const { return description_; }

private:
    /// The legend's swatches, drawn by the same programs as the scene.
    struct Swatches
    {
        SphereBuffer spheres;
        MeshBuffer polygons;
    };

    [[nodiscard]] SphereUniforms uniforms() const;
    void uploadMesh(const TriangleMesh& mesh);
    void uploadSwatches();
    void drawSwatches() const;
    [[nodiscard]] std::vector<glm::vec2> samplePositions() const;

    RenderSettings settings_;
    SphereColours colours_;
    Legend legend_;
    Framing still_;   ///< as the settings have it
    Framing framing_; ///< turned
    double turned_ = 0;
    std::optional<CutPlanes> cutPlanes_;
    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    std::string description_;
    Framebuffer framebuffer_;
    SpherePass spherePass_;
    std::optional<SpherePass> flatSpherePass_; ///< not in perspective, not cut, for the swatches
    MeshPass meshPass_;
    std::optional<MeshPass> wholeMeshPass_; ///< not cut, for the swatches
    SphereBuffer spheres_;
    ShadedMesh shaded_;
    std::unique_ptr<MeshBuffer> shell_;
    std::unique_ptr<Swatches> swatches_;
    std::vector<std::unique_ptr<SurfacePass>> surfacePasses_; ///< one for each size
    std::vector<SphereInstance> instances_; ///< reused from frame to frame
};

} // namespace frostfill
