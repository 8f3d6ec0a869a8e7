// SPDX-License-Identifier: MIT
// Room: the renderer, which draws a Snapshot without a screen. It puts the inner rooms together
// and knows nothing of physics.
#pragma once

#include "render/context/context.hpp"
#include "render/context/framebuffer.hpp"
#include "render/layer/scene_painter.hpp"
#include "render/layer/static_layer.hpp"
#include "render/passes/sphere_pass.hpp"
#include "render/picture/picture_backend.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_draw_list.hpp"

#include <frostfill/renderer.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Everything that draws on OpenGL's side: the context, what is uploaded to it, and what is kept
/// from picture to picture. The public Renderer adds the text and the clock.
class Pipeline : public PictureBackend
{
public:
    Pipeline(const TriangleMesh& mesh, const RenderSettings& settings);
    ~Pipeline() override;
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    const std::vector<PixelRectangle>& draw(const Snapshot& snapshot, Image& image) override;
    void readBack(Image& image, std::span<const PixelRectangle> parts) override;
    void drawSurfaces(const Snapshot& snapshot, const PictureSize& size,
                      Surfaces& surfaces) override;
    [[nodiscard]] const std::string& description() const override { return description_; }

    /// Window depth in 0..1, top row first; for samples == 1.
    [[nodiscard]] std::vector<double> readDepth();

    using PictureBackend::spheres;

private:
    [[nodiscard]] std::vector<glm::vec2> samplePositions() const;
    void useFraming() override;
    void useShell() override;
    void drawEverything();
    void updateLayer(const Changes& changes, const PixelRectangle& polygons);
    /// The part, as far as it lies in the picture, has to be renewed, too.
    void addDirty(const PixelRectangle& part);
    void drawOverLayer();

    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    std::string description_;
    Framebuffer framebuffer_;
    ScenePainter painter_;
    std::optional<StaticLayer> layer_;
    std::unique_ptr<SurfacePass> surfacePass_; ///< of the size that was asked for last
    SphereProjector projector_;
    PixelRectangle dirty_;                ///< the part that differs from the picture before
    PixelRectangle running_;              ///< where spheres that run were drawn over the layer
    std::vector<SphereInstance> spheres_; ///< that run and can be seen
    std::vector<PicturePart> parts_;      ///< [spheres_] where
    std::vector<PixelRectangle> renewed_; ///< what draw() returns
};

} // namespace frostfill
