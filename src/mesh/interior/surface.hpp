// SPDX-License-Identifier: MIT
// Room: the closed surface as the simulation sees it: contacts, inside and outside, volume. It
// assumes a mesh that has been repaired.
#pragma once

#include "geometry/closest_point.hpp"
#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/interior/walls.hpp"

#include <frostfill/mesh.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// A triangle with everything that a one-sided contact needs. Normals point into the object.
struct SurfaceTriangle
{
    std::array<Eigen::Vector3d, 3> corner;
    Eigen::Vector3d normal;                      ///< of the plane
    double offset = 0;                           ///< normal . x for points x of the plane
    std::array<Eigen::Vector3d, 7> pseudonormal; ///< by TriangleFeature, not normalised
    /// By TriangleFeature: whether all triangles at this edge or corner lie in one plane. A sphere
    /// that touches such a feature also touches one of the faces.
    std::array<bool, 7> flat = {};
    /// Whether both sides act, and the winding number tells which of them is inside: see Walls.
    bool twoSided = false;
};

/// The plane of a triangle and a sphere around it, in one cache line, for quick rejection.
struct alignas(64) TriangleBound
{
    Eigen::Vector3d normal;
    double offset = 0;
    Eigen::Vector3d centre;
    double radius = 0;

    /// False only if every point of the triangle is farther than `distance` from p.
    [[nodiscard]] bool mayBeWithin(double distance, const Eigen::Vector3d& p) const
    {
        return toPlane(p) <= distance && ballIsWithin(distance, toCentreSquared(p));
    }
    [[nodiscard]] double toPlane(const Eigen::Vector3d& p) const
    {
        return std::abs(normal.dot(p) - offset);
    }
    [[nodiscard]] double toCentreSquared(const Eigen::Vector3d& p) const
    {
        return (p - centre).squaredNorm();
    }
    /// Of a point by its distance to the centre.
    [[nodiscard]] bool ballIsWithin(double distance, double centreSquared) const
    {
        const double reach = radius + distance;
        return centreSquared <= reach * reach;
    }
};

/// A closed surface prepared for contact: the sign of the distance follows from the angle-weighted
/// pseudonormal of the closest feature [Baerentzen & Aanaes 2005], but for two-sided triangles.
class Surface
{
public:
    /// `mesh` is closed and wound outwards. It may cross itself.
    explicit Surface(const TriangleMesh& mesh) : Surface(mesh, classifyWalls(mesh)) {}
    /// With the walls known: of this mesh, or of one that differs by a scale and an offset.
    Surface(const TriangleMesh& mesh, const Walls& walls);

    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] const SurfaceTriangle& operator[](std::size_t i) const { return triangles_[i]; }
    [[nodiscard]] std::span<const SurfaceTriangle> triangles() const { return triangles_; }
    [[nodiscard]] const TriangleBound& bound(std::size_t i) const { return bounds_[i]; }
    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] bool anyTwoSided() const { return anyTwoSided_; }
    [[nodiscard]] const TriangleBvh& tree() const { return tree_; }

    /// Angle-weighted unit normal of a vertex, into the object.
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
    TriangleBvh tree_;
    bool anyTwoSided_ = false;
};

/// Distance to a triangle, positive on the inner side of the surface, and on both sides of a
/// two-sided triangle.
struct SignedDistance
{
    double value = 0;
    Eigen::Vector3d closest;
    TriangleFeature feature = TriangleFeature::face;
};
[[nodiscard]] SignedDistance signedDistance(const SurfaceTriangle& triangle,
                                            const Eigen::Vector3d& p);

/// Signed distance to the nearest of several triangles. Two equally near triangles share an edge or
/// a corner and have the same pseudonormal there, so both give the right sign. `ids` is not empty.
/// Its value is infinite where none is within `distance` of p.
[[nodiscard]] SignedDistance
nearestDistance(const Surface& surface, std::span<const std::uint32_t> ids,
                const Eigen::Vector3d& p,
                double distance = std::numeric_limits<double>::infinity());

/// The same of all triangles; its value is infinite where none is within `distance` of p.
[[nodiscard]] SignedDistance nearestDistance(const Surface& surface, const Eigen::Vector3d& p,
                                             double distance);

struct WallPoint
{
    double square = std::numeric_limits<double>::infinity(); ///< of the distance
    Eigen::Vector3d point;
};

/// The nearest point of all triangles, or any that is nearer than `enough`. Where none is within
/// `distance` of p, one beyond it, or none.
[[nodiscard]] WallPoint nearestWall(const Surface& surface, const Eigen::Vector3d& p,
                                    double distance, double enough);

} // namespace frostfill
