// SPDX-License-Identifier: MIT
#include "simulation/contact/sphere_cast.hpp"

#include "simulation/contact/contact.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

// Exact: the first root of |p + t direction - centre| = reach.
double castAtSpheres(const NeighbourList& around, const Eigen::Vector3d& p,
                     const Eigen::Vector3d& direction, double limit)
{
    for (const auto& [x, y, z, reach] : around.spheres())
    {
        const double dx = x - p.x();
        const double dy = y - p.y();
        const double dz = z - p.z();
        const double along = dx * direction.x() + dy * direction.y() + dz * direction.z();
        const double squared = dx * dx + dy * dy + dz * dz;
        const double discriminant = reach * reach - (squared - along * along);
        if (along < kSlides * reach || discriminant <= 0)
        {
            continue;
        }
        limit = std::min(limit, std::max(0.0, along - std::sqrt(discriminant)));
    }
    return limit;
}

} // namespace

bool mayTouch(const TriangleBound& bound, const Eigen::Vector3d& p, double radius,
              const Eigen::Vector3d& direction, double path)
{
    if (path <= kReached)
    {
        return bound.mayBeWithin(radius + path, p);
    }
    const double height = bound.normal.dot(p) - bound.offset;
    const double rise = path * bound.normal.dot(direction);
    const double nearest =
        height > 0 ? std::min(height, height + rise) : -std::max(height, height + rise);
    return nearest < radius + kTouch &&
           bound.mayBeWithin(radius + kReached + path / 2, p + path / 2 * direction);
}

// The distance to a triangle is a convex function of the way gone, so it never falls below its
// tangent: Newton's steps approach the contact from in front and never pass it. No use for the
// kernel's contact here: a cast asks from both sides of a wall, and only along its direction.
double castAtTriangle(const Surface& surface, std::uint32_t id, const Eigen::Vector3d& p,
                      double radius, const Eigen::Vector3d& direction, double limit)
{
    double path = 0;
    for (int step = 0; step < kNewtonSteps && path < limit; ++step)
    {
        const Eigen::Vector3d here = p + path * direction;
        const UnsignedDistance wall = unsignedDistance(surface, id, here);
        const auto& [point, feature] = wall.closest;
        const double gap = wall.value - radius;
        const double approach = (point - here).dot(direction) / wall.value;
        const double next = path + gap / approach;
        if (approach < kSlides || (gap >= kReached && next >= limit))
        {
            return limit;
        }
        // Along a plane the next triangle of the same plane is no obstacle, though the edge between
        // them comes nearer.
        if (surface[id].isFlat(feature) &&
            std::abs(surface.bound(id).normal.dot(direction)) < kSlidesAlongPlane)
        {
            return limit;
        }
        if (gap < kReached)
        {
            return path;
        }
        path = next;
    }
    return std::min(path, limit);
}

double sphereCast(const Surface& surface, NeighbourList& around, const Eigen::Vector3d& p,
                  double radius, const Eigen::Vector3d& direction, double limit)
{
    double path = castAtSpheres(around, p, direction, limit);
    const Eigen::Vector3d end = p + path * direction;
    for (const std::uint32_t triangle : around.trianglesOnWay(p, end, radius + kReached))
    {
        if (mayTouch(surface.bound(triangle), p, radius, direction, path))
        {
            path = castAtTriangle(surface, triangle, p, radius, direction, path);
        }
    }
    return path;
}

Eigen::Vector3d contactNormals(const Surface& surface, NeighbourList& around,
                               const Eigen::Vector3d& p, double radius, double gap,
                               std::vector<Eigen::Vector3d>& normals)
{
    Eigen::Vector3d pushOut = Eigen::Vector3d::Zero();
    double deepest = kCrept * radius;
    normals.clear();
    for (const Ball& other : around.spheres())
    {
        if (const auto contact = sphereContact(p - other.position(), other.radius, gap))
        {
            normals.push_back(contact->normal);
        }
    }
    for (const std::uint32_t triangle : around.trianglesNear(p, radius + gap))
    {
        if (const auto contact = frontContact(surface, triangle, p, radius, gap))
        {
            addNormal(normals, contact->normal);
            if (contact->depth > deepest)
            {
                deepest = contact->depth;
                pushOut = deepest * contact->normal;
            }
        }
    }
    return pushOut;
}

} // namespace frostfill
