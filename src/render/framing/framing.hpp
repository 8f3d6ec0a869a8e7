// SPDX-License-Identifier: MIT
// Room: from mesh coordinates to pixels: cameras, poses, cutaways. It needs no OpenGL.
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/snapshot.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <span>
#include <vector>

namespace frostfill
{

/// The part of the picture that the object is fitted into [pixel], from the upper left corner.
struct PictureRegion
{
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// From mesh coordinates to the picture. The mesh is first moved to its box's centre and scaled to
/// fit a sphere of radius 1 ("unit space"), in double precision: what OpenGL computes in single
/// precision is then the same for a mesh of micrometres far from its origin.
struct Framing
{
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< unit space's origin in mesh coordinates
    double scale = 1;                                 ///< unit length over mesh length
    glm::dmat4 view{1};                               ///< unit space to eye space
    glm::dmat4 projection{1};                         ///< eye space to clip space
    glm::dvec3 eye{0};   ///< unit space: the eye, or without perspective the direction towards it
    glm::dvec3 pivot{0}; ///< unit space: what a turntable turns about
    bool orthographic = false;
    double depthAtInfinity = 0; ///< window depth at infinity; perspective
    double depthSlope = 0;      ///< window depth over eye distance; orthographic
    glm::dvec4 heightPlane{0};  ///< with an eye-space point: 0 at the object's foot, 1 at its top
    glm::dvec4 distancePlane{
        0};               ///< with an eye-space point: 0 at the object's front, 1 at its back
    PictureRegion region; ///< into which the object is fitted
    double reach =
        0; ///< distance of the eye, or half the picture's height: smaller shows it larger

    [[nodiscard]] glm::dvec3 toUnit(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d unit = (point - centre) * scale;
        return {unit.x(), unit.y(), unit.z()};
    }
};

/// Share of the region that stays free around the object.
inline constexpr double kFramingMargin = 0.04;

/// Spheres that have leaked out of the object are drawn up to this distance from it [unit space].
inline constexpr double kDepthPadding = 0.5;

/// Nearest the near plane comes to the eye, over the eye's distance; keeps depth exact.
inline constexpr double kNearShare = 0.02;

/// Where the camera stands if nothing is known of the object. [degree]
inline constexpr double kUsualAzimuth = 30;

/// Looks at all the vertices from the camera's direction, from so far away that they just fill the
/// region (at zoom 1). Throws Error usage for a camera that makes no sense.
[[nodiscard]] Framing frame(std::span<const Eigen::Vector3d> vertices,
                            const RenderSettings& settings, const PictureRegion& region);

/// The same picture after the camera has gone round the pivot by an angle about the up axis
/// [degree].
[[nodiscard]] Framing revolved(const Framing& framing, const Eigen::Vector3d& up, double degrees);

/// Nearest and furthest distance that a projection shows, in unit space.
struct DepthLimits
{
    double nearest, furthest;
};
[[nodiscard]] DepthLimits depthLimits(const glm::dmat4& projection, bool orthographic);

/// Vertices of a mesh in unit space.
[[nodiscard]] std::vector<glm::vec3> inUnitSpace(const TriangleMesh& mesh, const Framing& framing);

/// The direction of a vector.
[[nodiscard]] inline glm::dvec3 unitVector(const Eigen::Vector3d& v)
{
    const Eigen::Vector3d unit = v.normalized();
    return {unit.x(), unit.y(), unit.z()};
}

/// The horizontal direction, in mesh or unit space, in which a camera at this azimuth [degree]
/// stands.
[[nodiscard]] glm::dvec3 horizontalDirection(const Eigen::Vector3d& up, double azimuth);

/// The azimuth of a camera that sees the object's front [degree]: 30, or 210 where that would show
/// its back. Files do not say where the front is. An animal's head is high and in front, so that
/// its upper half leans forward; an object that leans to no side has no back.
[[nodiscard]] double frontAzimuth(const TriangleMesh& mesh, const Eigen::Vector3d& up);

/// Two planes in unit space; a point (x, y, z, 1) is taken away when its product with both is
/// positive. Of a single plane both are the same.
using CutPlanes = std::array<glm::dvec4, 2>;

/// For a cutaway that is not none.
[[nodiscard]] CutPlanes cutPlanes(const Cutaway& cutaway, const Framing& framing,
                                  const Eigen::Vector3d& up);

/// The same planes for points in eye space.
[[nodiscard]] std::array<glm::vec4, 2> toEyeSpace(const CutPlanes& planes, const Framing& framing);

/// The mesh's vertices in all poses that have to fit into the picture; as they are without poses.
[[nodiscard]] std::vector<Eigen::Vector3d> verticesInPoses(const std::vector<Eigen::Vector3d>& mesh,
                                                           const std::vector<Pose>& poses);

/// What the camera sees when the object has moved into a pose about `origin` [mesh coordinates]:
/// the same as if the camera had moved the other way round it.
[[nodiscard]] Framing posed(const Framing& framing, const Pose& pose,
                            const Eigen::Vector3d& origin);

} // namespace frostfill
