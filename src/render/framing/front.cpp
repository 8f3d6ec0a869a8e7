// SPDX-License-Identifier: MIT
#include "render/framing/front.hpp"

#include "render/framing/framing.hpp"

#include <Eigen/Geometry>

#include <array>

namespace frostfill
{
namespace
{

/// Less than this, over half the largest edge of the object's box, is no leaning.
constexpr double kMin = 0.25;

/// Cosine of the angle between view and leaning from which on it is the back that is seen.
constexpr double kBehind = -0.8;

} // namespace

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
    const bool leans = lean.norm() > kMin * box.sizes().maxCoeff() / 2;
    const bool behind = lean.dot(Eigen::Vector3d(view.x, view.y, view.z)) < kBehind * lean.norm();
    return leans && behind ? kUsualAzimuth + 180 : kUsualAzimuth;
}

} // namespace frostfill
