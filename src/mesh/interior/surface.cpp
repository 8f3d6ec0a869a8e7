// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace frostfill
{
namespace
{

/// The sum of equal vectors has at least this share of their total length; the rest is rounding.
/// Larger: rounding makes edges of planes, on which spheres stumble. Smaller: a slight bend counts
/// as flat, and spheres pass through its edge by as little.
constexpr double kFlat = 1 - 1e-12;

double cornerAngle(const Eigen::Vector3d& at, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    const Eigen::Vector3d u = b - at;
    const Eigen::Vector3d v = c - at;
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

TriangleBound boundOf(const SurfaceTriangle& triangle)
{
    TriangleBound bound;
    bound.normal = triangle.normal;
    bound.offset = triangle.offset;
    bound.centre = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) / 3;
    for (const Eigen::Vector3d& corner : triangle.corner)
    {
        bound.radius = std::max(bound.radius, (corner - bound.centre).norm());
    }
    return bound;
}

} // namespace

Surface::Surface(const TriangleMesh& mesh)
    : mesh_(mesh), triangles_(mesh.triangles.size()), bounds_(mesh.triangles.size()),
      vertexNormals_(mesh.vertices.size(), Eigen::Vector3d::Zero())
{
    // The planes, and the contribution of each triangle to the normals of its edges and corners.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Eigen::Vector3d> edgeNormals;
    std::vector<double> anglesAtVertex(mesh.vertices.size(), 0);
    const auto edgeKey = [](std::uint32_t a, std::uint32_t b)
    { return std::make_pair(std::min(a, b), std::max(a, b)); };
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        SurfaceTriangle& triangle = triangles_[t];
        const auto& index = mesh.triangles[t];
        for (int k = 0; k < 3; ++k)
        {
            triangle.corner[k] = mesh.vertices[index[k]];
            box_.extend(triangle.corner[k]);
        }
        const auto& [a, b, c] = triangle.corner;
        triangle.normal = (c - a).cross(b - a).normalized();
        triangle.offset = triangle.normal.dot(a);
        bounds_[t] = boundOf(triangle);
        for (int k = 0; k < 3; ++k)
        {
            const int next = (k + 1) % 3;
            const auto [entry, isNew] =
                edgeNormals.try_emplace(edgeKey(index[k], index[next]), Eigen::Vector3d::Zero());
            entry->second += triangle.normal;
            const double angle = cornerAngle(triangle.corner[k], triangle.corner[next],
                                             triangle.corner[(k + 2) % 3]);
            vertexNormals_[index[k]] += triangle.normal * angle;
            anglesAtVertex[index[k]] += angle;
        }
    }

    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        const auto& index = mesh.triangles[t];
        auto& pseudonormal = triangles_[t].pseudonormal;
        for (int k = 0; k < 3; ++k)
        {
            pseudonormal[k] = vertexNormals_[index[k]];
            pseudonormal[3 + k] = edgeNormals.at(edgeKey(index[k], index[(k + 1) % 3]));
            // The sum keeps the total length only if all normals are equal.
            triangles_[t].flat[k] = pseudonormal[k].norm() > kFlat * anglesAtVertex[index[k]];
            triangles_[t].flat[3 + k] = pseudonormal[3 + k].norm() > kFlat * 2;
        }
        pseudonormal[6] = triangles_[t].normal;
    }
    for (Eigen::Vector3d& normal : vertexNormals_)
    {
        normal.normalize();
    }
}

SignedDistance signedDistance(const SurfaceTriangle& triangle, const Eigen::Vector3d& p)
{
    const ClosestPoint closest =
        closestPointOnTriangle(p, triangle.corner[0], triangle.corner[1], triangle.corner[2]);
    const Eigen::Vector3d toPoint = p - closest.point;
    const double side = toPoint.dot(triangle.pseudonormal[static_cast<int>(closest.feature)]);
    const double distance = toPoint.norm();
    return {side < 0 ? -distance : distance, closest.point, closest.feature};
}

SignedDistance nearestDistance(const Surface& surface, std::span<const std::uint32_t> ids,
                               const Eigen::Vector3d& p)
{
    SignedDistance nearest;
    nearest.value = std::numeric_limits<double>::infinity();
    for (const std::uint32_t id : ids)
    {
        if (!surface.bound(id).mayBeWithin(std::abs(nearest.value), p))
        {
            continue;
        }
        const SignedDistance candidate = signedDistance(surface[id], p);
        if (std::abs(candidate.value) < std::abs(nearest.value))
        {
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace frostfill
