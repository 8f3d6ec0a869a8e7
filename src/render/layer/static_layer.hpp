// SPDX-License-Identifier: MIT
// Room: what stays the same from picture to picture. It keeps spheres at rest drawn and finds
// the parts of a picture that must be drawn again.
#pragma once

#include "render/context/framebuffer.hpp"
#include "render/layer/scene_painter.hpp"
#include "render/picture/projected_sphere.hpp"
#include "render/picture/sphere_draw_list.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// The furthest depth in each small block of a picture. What is further in all the blocks that it
/// can be seen in is hidden, and stays so for as long as nothing is taken away and the camera is
/// still.
class OcclusionMap
{
public:
    OcclusionMap(int width, int height);

    /// From now on nothing is hidden.
    void clear() { known_ = false; }
    /// Takes the depths of a part of the picture, in which all lie that hide: 24 bits above 8 that
    /// do not count, bottom row first.
    void build(const PixelRectangle& part, std::span<const std::uint32_t> depths);
    [[nodiscard]] bool hides(const ProjectedSphere& sphere) const;

private:
    int columns_;
    bool known_ = false;
    std::vector<float> furthest_; ///< [rows x columns]
};

/// The picture without the spheres that run: background, spheres at rest and shell, with
/// their depths. Every frame starts from it, so that what cannot change is not drawn again.
class StaticLayer
{
public:
    /// `paintsOccluders` as the painter says. With several samples nothing is found hidden without.
    StaticLayer(const GlFunctions& gl, const PictureSize& size, int samples, bool paintsOccluders);

    /// Draws it anew. `resting` is in the order in which depths that are equal are decided; the
    /// nearer the first of them are, the more is found to be hidden and left out.
    void rebuild(ScenePainter& painter, const SphereProjector& projector,
                 std::span<const SphereInstance> resting);
    /// Draws `resting` from `first` on over what is there. Returns where.
    PixelRectangle add(ScenePainter& painter, const SphereProjector& projector,
                       std::span<const SphereInstance> resting, std::size_t first);
    /// Draws this part anew. `scratch` is a framebuffer of the same shape that is drawn to, in the
    /// part that is returned.
    PixelRectangle repaint(ScenePainter& painter, std::span<const SphereInstance> resting,
                           const PixelRectangle& wanted, const Framebuffer& scratch);

    /// Where one of the spheres at rest may be seen; empty when it is hidden or out of view.
    [[nodiscard]] PixelRectangle visiblePart(std::size_t resting) const;
    /// Hidden by what is at rest, and out of view for as long as the camera is still.
    [[nodiscard]] bool hides(const ProjectedSphere& sphere) const
    {
        return sphere.pixels.empty() || occlusion_.hides(sphere);
    }

    [[nodiscard]] const Framebuffer& framebuffer() const { return framebuffer_; }

private:
    /// One of the spheres at rest that may be seen.
    struct Seen
    {
        std::uint32_t index;
        PixelRectangle pixels;
    };

    void projectSpheres(const SphereProjector& projector, std::span<const SphereInstance> resting,
                        std::size_t first, std::size_t end);
    void findHidden(ScenePainter& painter, const SphereProjector& projector);
    void forgetHidden(ScenePainter& painter, const SphereProjector& projector,
                      std::span<const SphereInstance> resting);

    Framebuffer framebuffer_;              ///< of the layer
    std::optional<Framebuffer> occluders_; ///< depths without multisampling
    OcclusionMap occlusion_;
    std::vector<Seen> seen_;              ///< ascending
    std::size_t seenAtLast_ = 0;          ///< when those that are hidden were last looked for
    std::vector<SphereInstance> spheres_; ///< that are being drawn
    std::vector<PicturePart> parts_;      ///< [spheres_] where
    PixelRectangle drawn_;                ///< around all that is in the layer
    std::vector<std::uint32_t> depths_;
};

} // namespace frostfill
