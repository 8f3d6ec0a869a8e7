// SPDX-License-Identifier: MIT
// Room: the renderer, which draws a Snapshot without a screen. It puts the inner rooms together
// and knows nothing of physics.
#pragma once

#include "render/context/context.hpp"
#include "render/context/framebuffer.hpp"
#include "render/layer/dirty_rectangles.hpp"
#include "render/layer/projected_sphere.hpp"
#include "render/layer/scene_painter.hpp"
#include "render/layer/sphere_draw_list.hpp"
#include "render/layer/static_layer.hpp"
#include "render/overlay/viewpoint.hpp"
#include "render/passes/surface_pass.hpp"

#include <frostfill/renderer.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Everything that draws on OpenGL's side: the context, what is uploaded to it, and what is kept
/// from picture to picture. The public Renderer adds the text and the clock.
class Pipeline
{
public:
    Pipeline(const TriangleMesh& mesh, const RenderSettings& settings);
    ~Pipeline();
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    /// As Viewpoint has them.
    void lookFrom(const Camera& camera);
    void turn(double degrees);

    /// Draws and waits until it is done. Returns the parts of the picture that may differ from the
    /// one before, until the next call.
    const std::vector<PixelRectangle>& draw(const Snapshot& snapshot);
    /// What is seen of the spheres, in a picture of any size with the same view.
    void drawSurfaces(const Snapshot& snapshot, const PictureSize& size, Surfaces& surfaces);
    /// RGB or, where the background is not opaque, RGBA; top row first. What lies outside of
    /// `parts` is left alone in a picture of this shape.
    void readColour(Image& image, std::span<const PixelRectangle> parts);
    void readColour(Image& image);
    /// Window depth in 0..1, top row first; for samples == 1.
    [[nodiscard]] std::vector<double> readDepth();

    [[nodiscard]] const Framing& framing() const { return viewpoint_.framing(); }
    [[nodiscard]] const Legend& legend() const { return viewpoint_.legend(); }
    [[nodiscard]] const std::string& description() const { return description_; }
    /// Of the last picture, in the order in which they were drawn.
    [[nodiscard]] const SphereDrawList& spheres() const { return drawList_; }

private:
    [[nodiscard]] std::vector<glm::vec2> samplePositions() const;
    void useFraming();
    /// Looks at the object where it is in the snapshot.
    void follow(const Snapshot& snapshot);
    void updateSphereOcclusion(const SphereDrawList::Changes& changes, bool startAgain);
    void drawEverything();
    void updateLayer(const SphereDrawList::Changes& changes,
                     std::span<const PixelRectangle> polygonParts, bool startAgain);
    void drawOverLayer();
    void renewStencil();

    Viewpoint viewpoint_;
    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    std::string description_;
    Framebuffer framebuffer_;
    ScenePainter painter_;
    std::optional<StaticLayer> layer_;
    SphereProjector projector_;
    SphereDrawList drawList_;
    bool stale_ = true;                   ///< nothing of the picture before can be kept
    DirtyRectangles dirty_;               ///< parts of the picture that differ from the one before
    DirtyRectangles covered_;             ///< parts of the layer that are drawn anew
    std::vector<PixelRectangle> running_; ///< where spheres that run were drawn over the layer
    std::vector<SphereInstance> spheres_; ///< that run and can be seen
    std::vector<TriangleTiles::Part> parts_;                  ///< [spheres_] where
    std::vector<std::unique_ptr<SurfacePass>> surfacePasses_; ///< one for each size
};

} // namespace frostfill
