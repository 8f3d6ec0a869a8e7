// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"

#include <frostfill/error.hpp>

#include <Eigen/Geometry>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace frostfill
{

namespace
{

/// Less than this, over half the largest edge of the object's box, is no leaning.
constexpr double kLeastLean = 0.25;

/// Cosine of the angle between view and leaning from which on it is the back that is seen.
constexpr double kBehind = -0.8;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Directions of the picture in unit space.
struct Axes
{
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 back; ///< towards the viewer
};

void check(const RenderSettings& settings)
{
    const Camera& camera = settings.camera;
    const bool finite = std::isfinite(camera.azimuth.value_or(0)) && std::isfinite(camera.zoom) &&
                        (!camera.target || camera.target->allFinite()) && settings.up.allFinite();
    if (!finite || settings.up.norm() < 1e-9)
    {
        throw Error(ErrorCode::usage, "the camera's numbers must be finite and its up not zero");
    }
    if (!(camera.elevation >= -90 && camera.elevation <= 90))
    {
        throw Error(ErrorCode::usage, "the camera's elevation must be between -90 and 90 degrees");
    }
    if (!(camera.fieldOfView >= 1 && camera.fieldOfView <= 150))
    {
        throw Error(ErrorCode::usage,
                    "the camera's field of view must be between 1 and 150 degrees");
    }
    if (camera.distance && !(*camera.distance > 0 && std::isfinite(*camera.distance)))
    {
        throw Error(ErrorCode::usage, "the camera's distance must be positive");
    }
    if (!(camera.zoom > 0))
    {
        throw Error(ErrorCode::usage, "the camera's zoom must be positive");
    }
}

Axes axesOf(const Camera& camera, const Eigen::Vector3d& upwards)
{
    const glm::dvec3 up = unitVector(upwards);
    const double elevation = glm::radians(camera.elevation);
    const double azimuth = camera.azimuth.value_or(kUsualAzimuth);
    const glm::dvec3 around = horizontalDirection(upwards, azimuth);
    return {horizontalDirection(upwards, azimuth + 90),
            std::cos(elevation) * up - std::sin(elevation) * around,
            std::cos(elevation) * around + std::sin(elevation) * up};
}

/// In how many directions a vertex is looked at when the camera goes round. The body that a corner
/// of this polygon leaves out is 0.1 % of its radius: far less than the margin.
constexpr int kTurnSteps = 72;

/// All vertices, turned about the up axis through the pivot: what a turntable shows.
std::vector<Eigen::Vector3d> bodyOfRevolution(std::span<const Eigen::Vector3d> vertices,
                                              const Framing& framing, const Eigen::Vector3d& up)
{
    // Rings that lie in others add nothing: the widest of each height is kept.
    constexpr std::size_t kHeights = 512;
    const Eigen::Vector3d axis = up.normalized();
    const Eigen::Vector3d pivot =
        framing.centre +
        Eigen::Vector3d(framing.pivot.x, framing.pivot.y, framing.pivot.z) / framing.scale;
    struct Ring
    {
        double low = kInfinity, high = -kInfinity, radius = 0;
    };
    std::vector<Ring> rings(kHeights);
    for (const Eigen::Vector3d& vertex : vertices)
    {
        const Eigen::Vector3d p = vertex - pivot;
        const double height = axis.dot(p);
        const double inBox = axis.dot(vertex - framing.centre) * framing.scale; // -1..1
        const double place = (inBox + 1) / 2 * (kHeights - 1);
        Ring& ring = rings[std::min(static_cast<std::size_t>(std::max(place, 0.0)), kHeights - 1)];
        ring.low = std::min(ring.low, height);
        ring.high = std::max(ring.high, height);
        ring.radius = std::max(ring.radius, (p - height * axis).norm());
    }
    std::vector<Eigen::Vector3d> body;
    for (const Ring& ring : rings)
    {
        for (int step = 0; ring.low <= ring.high && step < kTurnSteps; ++step)
        {
            const glm::dvec3 out = horizontalDirection(up, 360.0 * step / kTurnSteps);
            const Eigen::Vector3d around =
                pivot + ring.radius * Eigen::Vector3d(out.x, out.y, out.z);
            body.emplace_back(around + ring.low * axis);
            body.emplace_back(around + ring.high * axis);
        }
    }
    return body;
}

/// The region in normalised device coordinates: centre and half width, margin taken off.
struct Window
{
    double x, y, halfWidth, halfHeight;
};

Window windowOf(const PictureRegion& region, const PictureSize& size)
{
    const double width = size.width;
    const double height = size.height;
    return {(region.left + region.right) / width - 1, 1 - (region.top + region.bottom) / height,
            (region.right - region.left) / width * (1 - kFramingMargin),
            (region.bottom - region.top) / height * (1 - kFramingMargin)};
}

/// Where the eye must stand along one axis of the picture, for the tangent t of half the angle that
/// the region covers. A point (x, z) is seen from (offset, distance) when |x - offset| <= t
/// (distance - z). The greatest x + t z and t z - x over all points bound t distance from below:
/// two linear conditions, so the smallest distance is theirs together.
struct AxisFit
{
    double offset, distance;
};

AxisFit fitPerspective(double plus, double minus, double tangent, bool centred)
{
    return centred ? AxisFit{(plus - minus) / 2, (plus + minus) / (2 * tangent)}
                   : AxisFit{0, std::max(plus, minus) / tangent};
}

AxisFit fitOrthographic(double low, double high, double share, bool centred)
{
    return centred ? AxisFit{(low + high) / 2, (high - low) / (2 * share)}
                   : AxisFit{0, std::max(-low, high) / share};
}

/// What the framing is computed from. Points are relative to the target, along the picture's axes.
struct Placement
{
    Axes axes;
    glm::dmat3 rotation; ///< unit space to the picture's axes
    Window window;
    double aspect = 1;
    double tangent = 0; ///< of half the field of view
    bool centred = true;
    glm::dvec3 target{0}; ///< in unit space
    glm::dvec3 low{kInfinity};
    glm::dvec3 high{-kInfinity};
    double right = -kInfinity, left = -kInfinity, top = -kInfinity, bottom = -kInfinity;
    double foot = kInfinity, head = -kInfinity; ///< along the up axis, in unit space
    glm::dvec3 upward{0, 1, 0};                 ///< the up axis along the picture's axes
    glm::dvec3 eye{0};
};

void setUnitSpace(Framing& framing, std::span<const Eigen::Vector3d> vertices)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : vertices)
    {
        box.extend(vertex);
    }
    if (!box.isEmpty() && box.diagonal().norm() > 0)
    {
        framing.centre = box.center();
        framing.scale = 2 / box.diagonal().norm();
    }
}

void measure(Placement& placement, const Framing& framing,
             std::span<const Eigen::Vector3d> vertices)
{
    const double tangentX = placement.tangent * placement.aspect * placement.window.halfWidth;
    const double tangentY = placement.tangent * placement.window.halfHeight;
    for (const Eigen::Vector3d& vertex : vertices)
    {
        const glm::dvec3 unit = framing.toUnit(vertex);
        const glm::dvec3 turned = placement.rotation * unit;
        const double height = glm::dot(turned, placement.upward);
        placement.foot = std::min(placement.foot, height);
        placement.head = std::max(placement.head, height);

        const glm::dvec3 p = placement.rotation * (unit - placement.target);
        placement.low = glm::min(placement.low, p);
        placement.high = glm::max(placement.high, p);
        placement.right = std::max(placement.right, p.x + tangentX * p.z);
        placement.left = std::max(placement.left, tangentX * p.z - p.x);
        placement.top = std::max(placement.top, p.y + tangentY * p.z);
        placement.bottom = std::max(placement.bottom, tangentY * p.z - p.y);
    }
}

/// `distance` of the eye in unit space, if it is given.
void placeEye(Placement& placement, Framing& framing, std::optional<double> distance)
{
    const Window& window = placement.window;
    const bool centred = placement.centred;
    if (framing.orthographic)
    {
        const AxisFit x = fitOrthographic(placement.low.x, placement.high.x,
                                          placement.aspect * window.halfWidth, centred);
        const AxisFit y =
            fitOrthographic(placement.low.y, placement.high.y, window.halfHeight, centred);
        framing.reach = std::max({x.distance, y.distance, 1e-6});
        placement.eye = {x.offset, y.offset, placement.high.z + 2 * kDepthPadding};
        return;
    }
    const double tangentX = placement.tangent * placement.aspect * window.halfWidth;
    const double tangentY = placement.tangent * window.halfHeight;
    const AxisFit x = fitPerspective(placement.right, placement.left, tangentX, centred);
    const AxisFit y = fitPerspective(placement.top, placement.bottom, tangentY, centred);
    framing.reach = distance.value_or(std::max({x.distance, y.distance, placement.high.z + 1e-3}));
    placement.eye = {x.offset, y.offset, framing.reach};
}

void setView(const Placement& placement, Framing& framing)
{
    const glm::dvec3 fromOrigin = placement.rotation * placement.target + placement.eye;
    framing.view = glm::dmat4(placement.rotation);
    framing.view[3] = glm::dvec4(-fromOrigin, 1);
    framing.eye = framing.orthographic ? placement.axes.back
                                       : glm::transpose(placement.rotation) * fromOrigin;

    const double tall = std::max(placement.head - placement.foot, 1e-6);
    framing.heightPlane = {placement.upward / tall,
                           (glm::dot(placement.upward, fromOrigin) - placement.foot) / tall};
    const double deep = std::max(placement.high.z - placement.low.z, 1e-6);
    framing.distancePlane = {0, 0, -1 / deep, (placement.high.z - placement.eye.z) / deep};
}

void setProjection(const Placement& placement, double zoom, Framing& framing)
{
    const double eye = placement.eye.z;
    const double nearest = std::max(eye - placement.high.z - kDepthPadding, kNearShare * eye);
    const double furthest = eye - placement.low.z + kDepthPadding;
    const double range = furthest - nearest;
    glm::dmat4& projection = framing.projection = glm::dmat4(0);
    if (framing.orthographic)
    {
        projection[0][0] = zoom / (framing.reach * placement.aspect);
        projection[1][1] = zoom / framing.reach;
        projection[2][2] = -2 / range;
        projection[3] = {placement.window.x, placement.window.y, -(furthest + nearest) / range, 1};
        framing.depthSlope = 1 / range;
        return;
    }
    projection[0][0] = zoom / (placement.tangent * placement.aspect);
    projection[1][1] = zoom / placement.tangent;
    projection[2] = {-placement.window.x, -placement.window.y, -(furthest + nearest) / range, -1};
    projection[3][2] = -2 * furthest * nearest / range;
    framing.depthAtInfinity = (1 + (furthest + nearest) / range) / 2;
}

} // namespace

Framing frame(std::span<const Eigen::Vector3d> vertices, const RenderSettings& settings,
              const PictureRegion& region)
{
    check(settings);
    static const Eigen::Vector3d nothing = Eigen::Vector3d::Zero();
    if (vertices.empty())
    {
        vertices = {&nothing, 1};
    }
    const Camera& camera = settings.camera;
    Framing framing;
    framing.orthographic = camera.orthographic;
    framing.region = region;
    setUnitSpace(framing, vertices);

    Placement placement;
    placement.axes = axesOf(camera, settings.up);
    placement.rotation =
        glm::transpose(glm::dmat3(placement.axes.right, placement.axes.up, placement.axes.back));
    placement.window = windowOf(region, settings.size);
    placement.aspect = static_cast<double>(settings.size.width) / settings.size.height;
    placement.tangent = std::tan(glm::radians(camera.fieldOfView) / 2);
    placement.centred = !camera.target.has_value();
    placement.target = placement.centred ? glm::dvec3(0) : framing.toUnit(*camera.target);
    const Eigen::Vector3d up = settings.up.normalized();
    placement.upward = placement.rotation * glm::dvec3(up.x(), up.y(), up.z());

    framing.pivot = placement.target;
    if (camera.turntable)
    {
        // It looks the same from every azimuth, so the camera's own will do.
        measure(placement, framing, bodyOfRevolution(vertices, framing, settings.up));
    }
    else
    {
        measure(placement, framing, vertices);
    }
    placeEye(placement, framing,
             camera.distance ? std::optional(*camera.distance * framing.scale) : std::nullopt);
    setView(placement, framing);
    setProjection(placement, camera.zoom, framing);
    return framing;
}

Framing revolved(const Framing& framing, const Eigen::Vector3d& up, double degrees)
{
    const glm::dvec3 axis = unitVector(up);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(degrees), axis);
    const glm::dvec3 about = framing.orthographic ? glm::dvec3(0) : framing.pivot;
    Framing turned = framing;
    turned.view = glm::translate(framing.view, framing.pivot) * glm::transpose(turn) *
                  glm::translate(glm::dmat4(1), -framing.pivot);
    turned.eye = glm::dvec3(turn * glm::dvec4(framing.eye - about, 1)) + about;
    return turned;
}

double frontAzimuth(const TriangleMesh& mesh, const Eigen::Vector3d& up)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (box.isEmpty())
    {
        return kUsualAzimuth;
    }
    // Centres of the surface's two halves, lower and upper.
    std::array<Eigen::Vector3d, 2> sums = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<double, 2> areas = {0, 0};
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const Eigen::Vector3d& first = mesh.vertices[a];
        const double area = (mesh.vertices[b] - first).cross(mesh.vertices[c] - first).norm() / 2;
        const Eigen::Vector3d middle =
            (first + mesh.vertices[b] + mesh.vertices[c]) / 3 - box.center();
        const std::size_t half = up.dot(middle) > 0 ? 1 : 0;
        sums[half] += area * middle;
        areas[half] += area;
    }
    if (!(areas[0] > 0 && areas[1] > 0))
    {
        return kUsualAzimuth;
    }
    const Eigen::Vector3d between = sums[1] / areas[1] - sums[0] / areas[0];
    const Eigen::Vector3d lean = between - up.dot(between) * up;
    const glm::dvec3 view = horizontalDirection(up, kUsualAzimuth);
    const bool leans = lean.norm() > kLeastLean * box.sizes().maxCoeff() / 2;
    const bool behind = lean.dot(Eigen::Vector3d(view.x, view.y, view.z)) < kBehind * lean.norm();
    return leans && behind ? kUsualAzimuth + 180 : kUsualAzimuth;
}

glm::dvec3 horizontalDirection(const Eigen::Vector3d& up, double azimuth)
{
    const glm::dvec3 upward = unitVector(up);
    // At azimuth 0 the x axis points to the right; where x is up, the y axis does.
    const glm::dvec3 side = std::abs(upward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(side - glm::dot(side, upward) * upward);
    const glm::dvec3 back = glm::cross(right, upward);
    const double angle = glm::radians(azimuth);
    return std::cos(angle) * back + std::sin(angle) * right;
}

CutPlanes cutPlanes(const Cutaway& cutaway, const Framing& framing, const Eigen::Vector3d& up)
{
    if (cutaway.kind == Cutaway::Kind::plane)
    {
        const Eigen::Vector3d normal = cutaway.normal.normalized();
        const glm::dvec4 plane(normal.x(), normal.y(), normal.z(), -cutaway.offset * framing.scale);
        return {plane, plane};
    }
    // Away from either face of the wedge, into it. The faces meet in the axis through the origin.
    return {glm::dvec4(horizontalDirection(up, cutaway.from + 90), 0),
            glm::dvec4(horizontalDirection(up, cutaway.to - 90), 0)};
}

std::array<glm::vec4, 2> toEyeSpace(const CutPlanes& planes, const Framing& framing)
{
    const glm::dmat4 fromPlanes = glm::transpose(glm::inverse(framing.view));
    return {glm::vec4(fromPlanes * planes[0]), glm::vec4(fromPlanes * planes[1])};
}

std::vector<Eigen::Vector3d> verticesInPoses(const std::vector<Eigen::Vector3d>& mesh,
                                             const std::vector<Pose>& poses)
{
    if (poses.empty())
    {
        return mesh;
    }
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : mesh)
    {
        box.extend(vertex);
    }
    const Eigen::Vector3d origin = box.center();
    std::vector<Eigen::Vector3d> vertices;
    for (const Pose& pose : poses)
    {
        for (const Eigen::Vector3d& vertex : mesh)
        {
            vertices.emplace_back(origin + pose.offset + pose.rotation * (vertex - origin));
        }
    }
    return vertices;
}

Framing posed(const Framing& framing, const Pose& pose, const Eigen::Vector3d& origin)
{
    // The pose as a matrix of unit space.
    const Eigen::Vector3d fromCentre = origin - framing.centre;
    const Eigen::Vector3d shift =
        framing.scale * (fromCentre + pose.offset - pose.rotation * fromCentre);
    glm::dmat4 matrix(1);
    for (int column = 0; column < 3; ++column)
    {
        for (int row = 0; row < 3; ++row)
        {
            matrix[column][row] = pose.rotation(row, column);
        }
        matrix[3][column] = shift[column];
    }
    Framing result = framing;
    result.view = framing.view * matrix;
    const double isPoint = framing.orthographic ? 0 : 1;
    result.eye = glm::dvec3(glm::inverse(matrix) * glm::dvec4(framing.eye, isPoint));
    return result;
}

DepthLimits depthLimits(const glm::dmat4& projection, bool orthographic)
{
    const double a = projection[2][2];
    const double b = projection[3][2];
    return orthographic ? DepthLimits{(b + 1) / a, (b - 1) / a}
                        : DepthLimits{b / (a - 1), b / (a + 1)};
}

std::vector<glm::vec3> inUnitSpace(const TriangleMesh& mesh, const Framing& framing)
{
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(framing.toUnit(vertex));
    }
    return positions;
}

} // namespace frostfill
