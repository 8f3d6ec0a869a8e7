// SPDX-License-Identifier: MIT
// Room: the content of a picture for every backend: spheres and shell with their light and
// colours, settings, dirty parts. It has the interface of a backend, and no OpenGL.
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"
#include "render/picture/drawn_shell.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/picture/studio.hpp"
#include "render/picture/surfaces.hpp"

#include <frostfill/image.hpp>
#include <frostfill/renderer.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// From where the object is seen, beside its legend and in which light, when the camera and the
/// object move.
class Viewpoint
{
public:
    /// Throws Error usage for settings that cannot be drawn.
    Viewpoint(const TriangleMesh& mesh, const RenderSettings& wanted);

    /// Looks from somewhere else from now on. Whether there is perspective cannot change. Throws
    /// Error usage for a camera that makes no sense.
    void lookFrom(const Camera& camera);
    /// Turns the camera about the up axis, from where lookFrom or the settings have it [degree].
    /// Returns whether that changes anything.
    bool turn(double degrees);
    /// Looks at the object where it is in the snapshot. Returns whether that changes anything.
    bool follow(const Snapshot& snapshot);

    /// With the azimuth of the front if none was given.
    [[nodiscard]] const RenderSettings& settings() const { return settings_; }
    [[nodiscard]] const SphereColours& colours() const { return colours_; }
    [[nodiscard]] const Legend& legend() const { return legend_; }
    [[nodiscard]] const Framing& framing() const { return framing_; }
    [[nodiscard]] const ShaderVariant& variant() const { return variant_; }
    /// None in other styles.
    [[nodiscard]] const std::optional<Studio>& studio() const { return studio_; }
    [[nodiscard]] const SphereUniforms& uniforms() const { return uniforms_; }

private:
    void renew();

    RenderSettings settings_;
    std::vector<Eigen::Vector3d> vertices_; ///< of the mesh, for framing
    SphereColours colours_;
    Legend legend_;
    Framing still_;   ///< as the camera has it
    Framing framing_; ///< turned, and with the object moved
    ShaderVariant variant_;
    std::optional<Studio> studio_;
    SphereUniforms uniforms_;                          ///< of the framing
    double turned_ = 0;                                ///< [degree]
    Pose pose_;                                        ///< of the object
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero(); ///< about which it is
};

/// What draws pictures of one mesh, and keeps from picture to picture what it likes.
class PictureBackend
{
public:
    PictureBackend(const TriangleMesh& mesh, const RenderSettings& settings);
    virtual ~PictureBackend() = default;
    PictureBackend(const PictureBackend&) = delete;
    PictureBackend& operator=(const PictureBackend&) = delete;

    /// As Viewpoint has them.
    void lookFrom(const Camera& camera);
    void turn(double degrees);

    /// Draws and waits until it is done. Returns the parts of the picture that may differ from the
    /// one before, until the next call. `image` has the picture after readBack().
    virtual const std::vector<PixelRectangle>& draw(const Snapshot& snapshot, Image& image) = 0;
    /// RGB or, where the background is not opaque, RGBA; top row first. What lies outside of
    /// `parts` is left alone in a picture of this shape.
    virtual void readBack(Image& image, std::span<const PixelRectangle> parts) = 0;
    /// What is seen of the spheres, in a picture of any size with the same view.
    virtual void drawSurfaces(const Snapshot& snapshot, const PictureSize& size,
                              Surfaces& surfaces) = 0;
    /// On one line.
    [[nodiscard]] virtual const std::string& description() const = 0;

    [[nodiscard]] const Framing& framing() const { return viewpoint_.framing(); }
    [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }

protected:
    /// Returns the mesh that is drawn as the shell.
    [[nodiscard]] const DrawnShell& shell() const { return shell_; }
    [[nodiscard]] const SphereDrawList& spheres() const { return drawList_; }
    /// Returns the spheres at rest as occluders; null without ambient occlusion.
    [[nodiscard]] SphereOcclusion* sphereOcclusion()
    {
        return sphereOcclusion_ ? &*sphereOcclusion_ : nullptr;
    }

    /// Looks at the object where it is in the snapshot.
    void follow(const Snapshot& snapshot);
    /// Differences from the picture before.
    struct Changes
    {
        const SphereDrawList::Changes& spheres;
        std::span<const std::uint32_t> triangles; ///< of the shell, in another state
        bool startAgain;                          ///< nothing of the picture before can be kept
    };
    /// Follows the snapshot, and takes its spheres and polygons. With `cells`, very many spheres at
    /// rest stand in cells, whatever the camera. The changes stay until the next call.
    Changes take(const Snapshot& snapshot, bool cells);

private:
    void renew();
    /// The framing has changed: nothing of the picture before can be kept.
    virtual void useFraming() = 0;
    /// So has the mesh of the shell.
    virtual void useShell() = 0;

    Viewpoint viewpoint_;
    DrawnShell shell_;
    SphereDrawList drawList_;
    std::optional<SphereOcclusion> sphereOcclusion_;
    bool stale_ = true; ///< nothing of the picture before can be kept
};

} // namespace frostfill
