// SPDX-License-Identifier: MIT
// Room: the closed surface as the simulation sees it: contacts, inside and outside, volume. It
// assumes a mesh that has been repaired.
#pragma once

#include "geometry/closest_point.hpp"
#include "mesh/interior/walls.hpp"

#include <frostfill/mesh.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// The plane of a triangle and a disc in it around the triangle, in one cache line, for quick
/// rejection.
struct alignas(64) TriangleBound
{
    Eigen::Vector3d normal; ///< of the plane, into the object
    double offset = 0;      ///< normal . x for points x of the plane
    Eigen::Vector3d centre;
    double radius = 0;

    /// False only if every point of the triangle is farther than `distance` from p. What a sphere
    /// that rests on a fine mesh has around it is within its radius of the planes of many triangles
    /// and of the balls around them, but of the discs of few.
    [[nodiscard]] bool mayBeWithin(double distance, const Eigen::Vector3d& p) const
    {
        const double height = toPlane(p);
        const double centreSquared = toCentreSquared(p);
        if (height > distance || !ballIsWithin(distance, centreSquared))
        {
            return false;
        }
        // Of the disc in which the plane cuts the ball around p; without a root of its radius.
        const double cutSquared = distance * distance * (1 + kDiscRounding) - height * height;
        const double rest = centreSquared - height * height - radius * radius - cutSquared;
        return rest <= 0 || rest * rest <= 4 * radius * radius * cutSquared;
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

private:
    /// [1] of a squared distance, far above its rounding. Larger: more triangles are tested.
    static constexpr double kDiscRounding = 1e-8;
};

[[nodiscard]] TriangleBound boundOf(const std::array<Eigen::Vector3d, 3>& corner);

/// What a contact asks of a triangle once it may be near. What several triangles share, the surface
/// keeps once.
struct SurfaceTriangle
{
    static constexpr std::uint32_t kListed = std::uint32_t{1} << 31;

    std::array<Eigen::Vector3d, 3> corner;
    /// Beyond the edge from each corner to the next: a triangle, or kListed + a place in the list
    /// of the normals of edges that do not have two triangles. The first in it is zero.
    std::array<std::uint32_t, 3> beyond = {kListed, kListed, kListed};
    std::uint8_t flatFeatures = 0; ///< a bit for each TriangleFeature
    /// Whether both sides act, and the winding number tells which of them is inside: see Walls.
    bool twoSided = false;

    /// Whether all triangles at this edge or corner lie in one plane. A sphere that touches such a
    /// feature also touches one of the faces.
    [[nodiscard]] bool isFlat(TriangleFeature feature) const
    {
        return ((flatFeatures >> static_cast<int>(feature)) & 1) != 0;
    }
};

/// A closed surface prepared for contact: the sign of the distance follows from the angle-weighted
/// pseudonormal of the closest feature [Baerentzen & Aanaes 2005], but for two-sided triangles.
class Surface
{
public:
    /// `mesh` is closed and wound outwards. It may cross itself.
    explicit Surface(const TriangleMesh& mesh) : Surface(mesh, MeshIndex(mesh)) {}
    Surface(const TriangleMesh& mesh, const Walls& walls) : Surface(mesh, walls, MeshIndex(mesh)) {}
    /// With the walls and the index known; the tree of the index is that of this mesh.
    Surface(TriangleMesh mesh, const Walls& walls, MeshIndex index);

    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] const SurfaceTriangle& operator[](std::size_t i) const { return triangles_[i]; }
    [[nodiscard]] std::span<const SurfaceTriangle> triangles() const { return triangles_; }
    [[nodiscard]] const TriangleBound& bound(std::size_t i) const { return bounds_[i]; }
    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] bool anyTwoSided() const { return anyTwoSided_; }
    [[nodiscard]] const TriangleBvh& tree() const { return tree_; }

    /// Angle-weighted unit normal of a vertex, into the object.
    [[nodiscard]] Eigen::Vector3d vertexNormal(std::size_t vertex) const
    {
        return vertexNormals_[vertex].normalized();
    }
    /// Of a feature of triangle `id`, into the object; not normalised.
    [[nodiscard]] Eigen::Vector3d pseudonormal(std::size_t id, TriangleFeature feature) const
    {
        if (feature == TriangleFeature::face)
        {
            return bounds_[id].normal;
        }
        const auto k = static_cast<std::size_t>(feature);
        if (k < 3)
        {
            return vertexNormals_[mesh_.triangles[id][k]];
        }
        const std::uint32_t beyond = triangles_[id].beyond[k - 3];
        return beyond < SurfaceTriangle::kListed ? bounds_[id].normal + bounds_[beyond].normal
                                                 : edgeNormals_[beyond - SurfaceTriangle::kListed];
    }

private:
    /// Braces, so that the walls are found before the index moves.
    Surface(const TriangleMesh& mesh, MeshIndex index)
        : Surface{mesh, classifyWalls(mesh, index), std::move(index)}
    {
    }

    void joinEdges(const EdgeTable& edges);
    void joinCorners();

    TriangleMesh mesh_;
    std::vector<SurfaceTriangle> triangles_;
    std::vector<TriangleBound> bounds_;
    std::vector<Eigen::Vector3d> vertexNormals_; ///< [#V] not normalised
    std::vector<Eigen::Vector3d> edgeNormals_;   ///< of edges that do not have two triangles
    Eigen::AlignedBox3d box_;
    TriangleBvh tree_;
    bool anyTwoSided_ = false;
};

/// Distance to triangle `id`, positive on the inner side of the surface, and on both sides of a
/// two-sided triangle.
struct SignedDistance
{
    double value = 0;
    Eigen::Vector3d closest;
    TriangleFeature feature = TriangleFeature::face;
};
[[nodiscard]] SignedDistance signedDistance(const Surface& surface, std::uint32_t id,
                                            const Eigen::Vector3d& p);

/// A distance whose side has not been asked for. Most triangles that are looked at turn out to be
/// too far away for it to matter, and its normal is elsewhere in memory.
struct UnsignedDistance
{
    double value = 0;
    ClosestPoint closest;
};
[[nodiscard]] inline UnsignedDistance unsignedDistance(const Surface& surface, std::uint32_t id,
                                                       const Eigen::Vector3d& p)
{
    const auto& [a, b, c] = surface[id].corner;
    const ClosestPoint closest = closestPointOnTriangle(p, a, b, c);
    return {(p - closest.point).norm(), closest};
}
/// signedDistance() of the same triangle and point.
[[nodiscard]] inline SignedDistance withSide(const Surface& surface, std::uint32_t id,
                                             const Eigen::Vector3d& p, const UnsignedDistance& its)
{
    const auto& [point, feature] = its.closest;
    const bool isBehind =
        !surface[id].twoSided && (p - point).dot(surface.pseudonormal(id, feature)) < 0;
    return {isBehind ? -its.value : its.value, point, feature};
}

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

} // namespace frostfill
