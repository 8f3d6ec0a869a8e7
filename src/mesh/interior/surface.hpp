// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/closest_point.hpp"

#include <frostfill/mesh.hpp>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace frostfill
{

/// One triangle with all that a one-sided contact needs. Normals point into the object.
struct SurfaceTriangle
{
    std::array<Eigen::Vector3d, 3> corner;
    Eigen::Vector3d normal;                      ///< of the plane
    double offset = 0;                           ///< normal . x of the plane's points
    std::array<Eigen::Vector3d, 7> pseudonormal; ///< by TriangleFeature, not normalised
    /// By TriangleFeature: all triangles that share this edge or corner lie in one plane. A sphere
    /// that touches it touches one of their faces just as well.
    std::array<bool, 7> flat = {};
};

/// What a first look at a triangle needs, in one cache line: its plane and a sphere around it.
struct alignas(64) TriangleBound
{
    Eigen::Vector3d normal;
    double offset = 0;
    Eigen::Vector3d centre;
    double radius = 0;

    /// False only when every point of the triangle is farther than `distance` from p.
    [[nodiscard]] bool mayBeWithin(double distance, const Eigen::Vector3d& p) const
    {
        if (std::abs(normal.dot(p) - offset) > distance)
        {
            return false;
        }
        const double reach = radius + distance;
        return (p - centre).squaredNorm() <= reach * reach;
    }
};

/// A closed surface prepared for contact: the sign of the distance follows from the angle-weighted
/// pseudonormal of the closest feature [Baerentzen & Aanaes 2005].
class Surface
{
public:
    /// `mesh` is closed and wound outwards.
    explicit Surface(const TriangleMesh& mesh);

    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] const SurfaceTriangle& operator[](std::size_t i) const { return triangles_[i]; }
    [[nodiscard]] std::span<const SurfaceTriangle> triangles() const { return triangles_; }
    [[nodiscard]] const TriangleBound& bound(std::size_t i) const { return bounds_[i]; }
    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

    /// Unit normal of each vertex, into the object, angle-weighted.
    [[nodiscard]] const Eigen::Vector3d& vertexNormal(std::size_t vertex) const
    {
        return vertexNormals_[vertex];
    }

private:
    TriangleMesh mesh_;
    std::vector<SurfaceTriangle> triangles_;
    std::vector<TriangleBound> bounds_;
    std::vector<Eigen::Vector3d> vertexNormals_;
    Eigen::AlignedBox3d box_;
};

/// Distance to one triangle, positive on the side of the object's inside.
struct SignedDistance
{
    double value = 0;
    Eigen::Vector3d closest;
    TriangleFeature feature = TriangleFeature::face;
};
[[nodiscard]] SignedDistance signedDistance(const SurfaceTriangle& triangle,
                                            const Eigen::Vector3d& p);

/// Signed distance to the nearest of several triangles. Where two are equally near (a shared edge
/// or corner) both give the same pseudonormal, so either sign is right. `ids` is not empty.
[[nodiscard]] SignedDistance nearestDistance(const Surface& surface,
                                             std::span<const std::uint32_t> ids,
                                             const Eigen::Vector3d& p);

} // namespace frostfill
