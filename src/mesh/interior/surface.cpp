// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

/// Sine of the angle to their mean normal up to which triangles lie in one plane. What slides along
/// one does not notice the next: two of them differ by less than sphere casts ignore along a plane.
/// Larger: a cast stops at a bend that gives no contact, and the sphere hangs there. Smaller:
/// rounding makes edges of planes, on which spheres stumble.
constexpr double kFlatBend = 7e-8;

/// The angle at a corner, by which its triangle counts there.
double weightAt(const SurfaceTriangle& triangle, std::size_t corner)
{
    const Eigen::Vector3d& at = triangle.corner[corner];
    const Eigen::Vector3d u = triangle.corner[(corner + 1) % 3] - at;
    const Eigen::Vector3d v = triangle.corner[(corner + 2) % 3] - at;
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Whether a triangle lies in the plane of the sum of the normals around an edge or a corner.
bool isInPlane(const Eigen::Vector3d& ofTriangle, const Eigen::Vector3d& sum)
{
    const Eigen::Vector3d unit = sum.normalized();
    return unit.dot(ofTriangle) > 0 && unit.cross(ofTriangle).norm() < kFlatBend;
}

void markFlat(SurfaceTriangle& triangle, unsigned feature)
{
    triangle.flatFeatures = static_cast<std::uint8_t>(triangle.flatFeatures | (1U << feature));
}

} // namespace

TriangleBound boundOf(const std::array<Eigen::Vector3d, 3>& corner)
{
    const auto& [a, b, c] = corner;
    TriangleBound bound;
    bound.normal = (c - a).cross(b - a).normalized();
    bound.offset = bound.normal.dot(a);
    bound.centre = (a + b + c) / 3;
    for (const Eigen::Vector3d& each : corner)
    {
        bound.radius = std::max(bound.radius, (each - bound.centre).norm());
    }
    return bound;
}

Surface::Surface(TriangleMesh mesh, const Walls& walls, MeshIndex index)
    : mesh_(std::move(mesh)), triangles_(mesh_.triangles.size()), bounds_(mesh_.triangles.size()),
      vertexNormals_(mesh_.vertices.size(), Eigen::Vector3d::Zero()), tree_(std::move(index.tree)),
      anyTwoSided_(!walls.none())
{
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        SurfaceTriangle& triangle = triangles_[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
            triangle.corner[k] = mesh_.vertices[mesh_.triangles[t][k]];
            box_.extend(triangle.corner[k]);
        }
        bounds_[t] = boundOf(triangle.corner);
        triangle.twoSided = anyTwoSided_ && walls.twoSided[t];
    }
    joinEdges(index.edges);
    joinCorners();
}

void Surface::joinEdges(const EdgeTable& edges)
{
    // Triangles that repeat a corner have no edges and no area: all their normals are zero.
    edgeNormals_.emplace_back(Eigen::Vector3d::Zero());
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const EdgeUse& use : uses)
            {
                sum += bounds_[use.triangle].normal;
            }
            const bool flat = std::all_of(uses.begin(), uses.end(),
                                          [&](const EdgeUse& use)
                                          { return isInPlane(bounds_[use.triangle].normal, sum); });
            const bool shared = uses.size() == 2;
            const auto listed =
                SurfaceTriangle::kListed + static_cast<std::uint32_t>(edgeNormals_.size());
            for (const EdgeUse& use : uses)
            {
                SurfaceTriangle& triangle = triangles_[use.triangle];
                const EdgeUse& other = use.triangle == uses[0].triangle ? uses.back() : uses[0];
                triangle.beyond[use.corner] = shared ? other.triangle : listed;
                if (flat)
                {
                    markFlat(triangle, 3U + use.corner);
                }
            }
            if (!shared)
            {
                edgeNormals_.push_back(sum);
            }
        });
}

void Surface::joinCorners()
{
    const auto forEach = [&](auto&& visit)
    {
        for (std::size_t corner = 0; corner < 3 * triangles_.size(); ++corner)
        {
            visit(corner / 3, corner % 3, mesh_.triangles[corner / 3][corner % 3]);
        }
    };
    forEach([&](std::size_t t, std::size_t k, std::uint32_t vertex)
            { vertexNormals_[vertex] += bounds_[t].normal * weightAt(triangles_[t], k); });
    std::vector<bool> bent(mesh_.vertices.size(), false);
    forEach(
        [&](std::size_t t, std::size_t, std::uint32_t vertex)
        { bent[vertex] = bent[vertex] || !isInPlane(bounds_[t].normal, vertexNormals_[vertex]); });
    forEach(
        [&](std::size_t t, std::size_t k, std::uint32_t vertex)
        {
            if (!bent[vertex])
            {
                markFlat(triangles_[t], static_cast<unsigned>(k));
            }
        });
}

SignedDistance signedDistance(const Surface& surface, std::uint32_t id, const Eigen::Vector3d& p)
{
    return withSide(surface, id, p, unsignedDistance(surface, id, p));
}

namespace
{

/// The nearest of the triangles that it meets, the first of several.
class NearestTriangle
{
public:
    NearestTriangle(const Surface& surface, const Eigen::Vector3d& p, double distance)
        : surface_(surface), p_(p), limit_(distance)
    {
    }
    void meet(std::uint32_t id)
    {
        const UnsignedDistance its = unsignedDistance(surface_, id, p_);
        if (its.value <= limit_ && (its.value < nearest_.value || id < id_))
        {
            nearest_ = its;
            id_ = id;
            limit_ = its.value;
        }
    }
    /// No triangle farther than this is the nearest.
    [[nodiscard]] double limit() const { return limit_; }
    [[nodiscard]] SignedDistance found() const
    {
        return std::isinf(nearest_.value) ? SignedDistance{nearest_.value, nearest_.closest.point}
                                          : withSide(surface_, id_, p_, nearest_);
    }

private:
    const Surface& surface_;
    const Eigen::Vector3d& p_;
    double limit_;
    UnsignedDistance nearest_{std::numeric_limits<double>::infinity(), {}};
    std::uint32_t id_ = 0;
};

} // namespace

SignedDistance nearestDistance(const Surface& surface, std::span<const std::uint32_t> ids,
                               const Eigen::Vector3d& p, double distance)
{
    NearestTriangle nearest(surface, p, distance);
    for (const std::uint32_t id : ids)
    {
        if (surface.bound(id).mayBeWithin(nearest.limit(), p))
        {
            nearest.meet(id);
        }
    }
    return nearest.found();
}

SignedDistance nearestDistance(const Surface& surface, const Eigen::Vector3d& p, double distance)
{
    NearestTriangle nearest(surface, p, distance);
    surface.tree().forEachTriangleNear(p, distance,
                                       [&](std::uint32_t id)
                                       {
                                           nearest.meet(id);
                                           return nearest.limit();
                                       });
    return nearest.found();
}

} // namespace frostfill
