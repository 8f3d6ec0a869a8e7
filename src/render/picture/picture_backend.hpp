// SPDX-License-Identifier: MIT
// Room: the content of a picture for every backend: spheres and shell with their light and
// colours, settings, dirty parts. It has the interface of a backend, and no OpenGL.
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"
#include "render/picture/drawn_shell.hpp"
#include "render/picture/surfaces.hpp"

#include <frostfill/image.hpp>
#include <frostfill/renderer.hpp>

#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// From where the object is seen, beside its legend, when the camera and the object move.
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

private:
    void renew();

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
    [[nodiscard]] const Legend& legend() const { return viewpoint_.legend(); }

protected:
    [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
    /// Returns the mesh that is drawn as the shell.
    [[nodiscard]] const DrawnShell& shell() const { return shell_; }
    /// Takes the states of its triangles. Returns which have changed, until the next call.
    std::span<const std::uint32_t> followShell(const Snapshot& snapshot)
    {
        return shell_.follow(snapshot.polygons);
    }
    /// Looks at the object where it is in the snapshot.
    void follow(const Snapshot& snapshot);

private:
    /// The framing has changed: nothing of the picture before can be kept.
    virtual void useFraming() = 0;
    /// So has the mesh of the shell.
    virtual void useShell() = 0;

    Viewpoint viewpoint_;
    DrawnShell shell_;
};

} // namespace frostfill
