// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"

#include "mesh/edge_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The triangles at an edge or a corner.
struct Fan
{
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< weighted sum, by angle at a corner
    bool flat = true;

    void bend(const Eigen::Vector3d& ofTriangle)
    {
        const Eigen::Vector3d unit = normal.normalized();
        flat = flat && unit.dot(ofTriangle) > 0 && unit.cross(ofTriangle).norm() < kFlatBend;
    }
};

void setFeature(SurfaceTriangle& triangle, std::size_t feature, const Fan& fan)
{
    triangle.pseudonormal[feature] = fan.normal;
    triangle.flat[feature] = fan.flat;
}

/// Returns the corners' fans [#V].
std::vector<Fan> setCorners(const TriangleMesh& mesh, std::vector<SurfaceTriangle>& triangles)
{
    std::vector<Fan> fans(mesh.vertices.size());
    const auto forEach = [&](auto&& visit)
    {
        for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner)
        {
            const std::size_t t = corner / 3;
            visit(triangles[t], corner % 3, fans[mesh.triangles[t][corner % 3]]);
        }
    };
    forEach([](const auto& triangle, std::size_t k, Fan& fan)
            { fan.normal += triangle.normal * weightAt(triangle, k); });
    forEach([](const auto& triangle, std::size_t, Fan& fan) { fan.bend(triangle.normal); });
    forEach([](auto& triangle, std::size_t k, const Fan& fan) { setFeature(triangle, k, fan); });
    return fans;
}

void setEdges(const TriangleMesh& mesh, std::vector<SurfaceTriangle>& triangles)
{
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            Fan fan;
            for (const EdgeUse& use : uses)
            {
                fan.normal += triangles[use.triangle].normal;
            }
            for (const EdgeUse& use : uses)
            {
                fan.bend(triangles[use.triangle].normal);
            }
            for (const EdgeUse& use : uses)
            {
                setFeature(triangles[use.triangle], 3U + use.corner, fan);
            }
        });
}

} // namespace

Surface::Surface(const TriangleMesh& mesh, const Walls& walls)
    : mesh_(mesh), triangles_(mesh.triangles.size()), bounds_(mesh.triangles.size()), tree_(mesh)
{
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        SurfaceTriangle& triangle = triangles_[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
            triangle.corner[k] = mesh.vertices[mesh.triangles[t][k]];
            box_.extend(triangle.corner[k]);
        }
        const auto& [a, b, c] = triangle.corner;
        triangle.normal = (c - a).cross(b - a).normalized();
        triangle.offset = triangle.normal.dot(a);
        triangle.pseudonormal.fill(triangle.normal);
        bounds_[t] = boundOf(triangle);
    }
    setEdges(mesh, triangles_);
    for (const Fan& fan : setCorners(mesh, triangles_))
    {
        vertexNormals_.push_back(fan.normal.normalized());
    }
    for (std::size_t t = 0; t < triangles_.size() && !walls.none(); ++t)
    {
        triangles_[t].twoSided = walls.twoSided[t];
    }
    anyTwoSided_ = !walls.none();
}

namespace
{

// Without a call within nearestDistance, which a run spends much of its time in.
[[gnu::always_inline]] inline SignedDistance distanceTo(const SurfaceTriangle& triangle,
                                                        const Eigen::Vector3d& p)
{
    const ClosestPoint closest =
        closestPointOnTriangle(p, triangle.corner[0], triangle.corner[1], triangle.corner[2]);
    const Eigen::Vector3d toPoint = p - closest.point;
    const double side = toPoint.dot(triangle.pseudonormal[static_cast<int>(closest.feature)]);
    const double distance = toPoint.norm();
    return {side < 0 && !triangle.twoSided ? -distance : distance, closest.point, closest.feature};
}

} // namespace

SignedDistance signedDistance(const SurfaceTriangle& triangle, const Eigen::Vector3d& p)
{
    return distanceTo(triangle, p);
}

SignedDistance nearestDistance(const Surface& surface, std::span<const std::uint32_t> ids,
                               const Eigen::Vector3d& p, double distance)
{
    SignedDistance nearest;
    nearest.value = std::numeric_limits<double>::infinity();
    double limit = distance;
    for (const std::uint32_t id : ids)
    {
        if (!surface.bound(id).mayBeWithin(limit, p))
        {
            continue;
        }
        const SignedDistance candidate = distanceTo(surface[id], p);
        if (std::abs(candidate.value) < std::abs(nearest.value))
        {
            nearest = candidate;
            limit = std::min(limit, std::abs(candidate.value));
        }
    }
    return nearest;
}

namespace
{

/// By how much something has to be farther than the nearest of p so that rounding does not hide
/// that it is nearer: a share of the distance and of the coordinates.
class Beyond
{
public:
    Beyond(const Surface& surface, const Eigen::Vector3d& p)
        : rounding_(kOfCoordinates * (p.cwiseAbs().maxCoeff() + surface.box().sizes().maxCoeff()))
    {
    }
    [[nodiscard]] double operator()(double distance) const
    {
        return distance * (1 + kOfDistance) + rounding_;
    }

private:
    static constexpr double kOfDistance = 1e-9;     // [1]
    static constexpr double kOfCoordinates = 1e-13; // [1]
    double rounding_;
};

} // namespace

// Of those that may be nearest but for rounding, the list decides, as it would among all.
SignedDistance nearestDistance(const Surface& surface, const Eigen::Vector3d& p, double distance)
{
    const Beyond beyond(surface, p);
    struct Candidate
    {
        double distance;
        std::uint32_t id;
    };
    std::vector<Candidate> candidates;
    double limit = beyond(distance);
    surface.tree().forEachNear(Eigen::AlignedBox3d(p), limit,
                               [&](std::span<const std::uint32_t> ids)
                               {
                                   for (const std::uint32_t id : ids)
                                   {
                                       if (surface.bound(id).mayBeWithin(limit, p))
                                       {
                                           const double its =
                                               std::abs(distanceTo(surface[id], p).value);
                                           if (its <= limit)
                                           {
                                               candidates.push_back({its, id});
                                               limit = std::min(limit, beyond(its));
                                           }
                                       }
                                   }
                                   return limit;
                               });
    std::erase_if(candidates, [&](const Candidate& each) { return each.distance > limit; });
    std::vector<std::uint32_t> ids(candidates.size());
    std::transform(candidates.begin(), candidates.end(), ids.begin(),
                   [](const Candidate& each) { return each.id; });
    std::sort(ids.begin(), ids.end());
    return nearestDistance(surface, ids, p);
}

WallPoint nearestWall(const Surface& surface, const Eigen::Vector3d& p, double distance,
                      double enough)
{
    const Beyond beyond(surface, p);
    WallPoint nearest;
    double limit = distance;
    const auto look = [&](std::uint32_t id)
    {
        if (nearest.square < enough * enough || !surface.bound(id).mayBeWithin(limit, p))
        {
            return;
        }
        const auto& [a, b, c] = surface[id].corner;
        const Eigen::Vector3d point = closestPointOnTriangle(p, a, b, c).point;
        const double square = (p - point).squaredNorm();
        if (square < nearest.square)
        {
            nearest = {square, point};
            limit = std::min(distance, beyond(std::sqrt(square)));
        }
    };
    surface.tree().forEachNear(Eigen::AlignedBox3d(p), limit,
                               [&](std::span<const std::uint32_t> ids)
                               {
                                   std::for_each(ids.begin(), ids.end(), look);
                                   return nearest.square < enough * enough ? 0 : limit;
                               });
    return nearest;
}

} // namespace frostfill
