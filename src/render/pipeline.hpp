// SPDX-License-Identifier: MIT
// Room: the renderer, which draws a Snapshot without a screen. It puts the inner rooms together
// and knows nothing of physics.
#pragma once

#include "render/context/context.hpp"
#include "render/context/framebuffer.hpp"
#include "render/framing/framing.hpp"
#include "render/layer/dirty_rectangles.hpp"
#include "render/layer/projected_sphere.hpp"
#include "render/layer/scene_painter.hpp"
#include "render/layer/sphere_ledger.hpp"
#include "render/layer/static_layer.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"
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

    /// Looks from somewhere else from now on. Whether there is perspective cannot change. Throws
    /// Error usage for a camera that makes no sense.
    void lookFrom(const Camera& camera);
    /// Turns the camera about the up axis, from where lookFrom or the settings have it [degree].
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

    [[nodiscard]] const Framing& framing() const { return framing_; }
    [[nodiscard]] const Legend& legend() const { return legend_; }
    [[nodiscard]] const std::string& description() const { return description_; }
    /// Of the last picture, in the order in which they were drawn.
    [[nodiscard]] const SphereLedger& spheres() const { return ledger_; }

private:
    [[nodiscard]] std::vector<glm::vec2> samplePositions() const;
    void useFraming();
    /// Looks at the object where it is in the snapshot.
    void follow(const Snapshot& snapshot);
    void renewSurroundings(const SphereLedger::Changes& changes);
    void drawEverything();
    void updateLayer(const SphereLedger::Changes& changes,
                     std::span<const PixelRectangle> polygonParts, bool startAgain);
    void drawOverLayer();
    void renewMarks();

    RenderSettings settings_;
    std::vector<Eigen::Vector3d> vertices_; ///< of the mesh, for framing
    SphereColours colours_;
    Legend legend_;
    Framing still_;                                    ///< as the camera has it
    Framing framing_;                                  ///< turned, and with the object moved
    double turned_ = 0;                                ///< [degree]
    bool moved_ = false;                               ///< the object has been in a pose of its own
    Pose pose_;                                        ///< of the object
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero(); ///< about which it is
    std::unique_ptr<Context> context_;
    GlFunctions gl_;
    std::string description_;
    Framebuffer framebuffer_;
    ScenePainter painter_;
    std::optional<StaticLayer> layer_;
    SphereProjector projector_;
    SphereLedger ledger_;
    bool stale_ = true;                   ///< nothing of the picture before can be kept
    DirtyRectangles dirty_;               ///< parts of the picture that differ from the one before
    DirtyRectangles covered_;             ///< parts of the layer that are drawn anew
    std::vector<PixelRectangle> running_; ///< where spheres that run were drawn over the layer
    std::vector<SphereInstance> spheres_; ///< that run and can be seen
    std::vector<TriangleTiles::Part> parts_;                  ///< [spheres_] where
    std::vector<std::unique_ptr<SurfacePass>> surfacePasses_; ///< one for each size
};

} // namespace frostfill
