// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"

#include <frostfill/renderer.hpp>

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

} // namespace frostfill
