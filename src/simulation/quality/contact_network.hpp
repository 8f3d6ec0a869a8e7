// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "mesh/interior/surface.hpp"
#include "simulation/quality/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// What a sphere touches, as the judge sees it: whatever is nearer than kContactGap of its own
/// radius.

/// Calls visit(row, apart, depth) for the spheres beside one that has this id: `apart` leads from
/// there to p, `depth` is negative for a gap [r].
template <class Visit>
void forEachSphereBeside(const SphereGrid& spheres, std::uint32_t id, const Eigen::Vector3d& p,
                         double radius, Visit&& visit)
{
    constexpr double kBeyond = 1 + 1e-9; // rounding
    const double gap = kContactGap * radius;
    spheres.forEachNear(p, radius + 1 + gap,
                        [&](std::uint32_t row)
                        {
                            const Eigen::Vector3d apart = p - spheres[row].position();
                            const double contact = radius + spheres[row].radius;
                            const double far = (contact + gap) * kBeyond;
                            if (apart.squaredNorm() > far * far)
                            {
                                return; // as most, without a root
                            }
                            const double depth = contact - apart.norm();
                            if (depth > -gap && spheres.id(row) != id)
                            {
                                visit(row, apart, depth);
                            }
                        });
}

/// Calls visit(triangle, away, distance) for the triangles beside a sphere: `away` leads to p from
/// the nearest point [r]. Walls act from both sides. `scratch` keeps its memory. The bounds of
/// triangles, by which the engine leaves some out, are not asked: a wrong one would go unseen.
template <class Visit>
void forEachTriangleBeside(const World& world, const Eigen::Vector3d& p, double radius,
                           std::vector<std::uint32_t>& scratch, Visit&& visit)
{
    const double reach = radius * (1 + kContactGap);
    for (const std::uint32_t t : world.triangles.near(p, reach, scratch))
    {
        const auto& [a, b, c] = world.surface[t].corner;
        const Eigen::Vector3d away = p - closestPointOnTriangle(p, a, b, c).point;
        const double distance = away.norm();
        if (distance <= reach)
        {
            visit(t, away, distance);
        }
    }
}

/// Adds the unit vector from a wall to the centre beside it, unless it is there already. A centre
/// on a wall is not beside it.
inline void addNormal(std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& away,
                      double distance)
{
    const Eigen::Vector3d normal = away / distance;
    const auto same = [&](const Eigen::Vector3d& n) { return n.dot(normal) > kSameWall; };
    if (distance > kOnWall && std::none_of(normals.begin(), normals.end(), same))
    {
        normals.push_back(normal);
    }
}

/// Pieces of wall that are beside a place: of those triangles the ones nearer than `reach`, and
/// farther than `onWall`, of which those that hang together at edges which are as near are one
/// piece. So the count does not depend on how finely a wall is divided.
[[nodiscard]] std::uint32_t wallPieces(const Surface& surface,
                                       std::span<const std::uint32_t> triangles,
                                       const Eigen::Vector3d& p, double reach, double onWall);

/// Contacts of a sphere: other spheres at rest whose gap to it is below kContactGap of its own
/// radius, and pieces of wall at most as far away. Triangles that hang together at edges which are
/// as near are one piece, so that the count does not depend on how finely a wall is divided. A wall
/// through the centre does not count. Of a running sphere: 0.
[[nodiscard]] std::uint32_t restingContacts(const World& world, std::uint32_t id);

/// Spheres at rest, and where they push one another and walls push them.
struct ContactNetwork
{
    static constexpr std::uint32_t kWall = 0xffffffff;

    struct Body
    {
        Eigen::Vector3d pull; ///< direction in which it is pulled; 0 where it is weightless
        double radius;        ///< [r]
    };
    /// One that pushes `upon` along the normal, and `from`, unless that is kWall, against it.
    struct Contact
    {
        Eigen::Vector3d normal;
        std::uint32_t upon;
        std::uint32_t from;
    };

    std::vector<Body> bodies;
    std::vector<Contact> contacts;
    /// Of spheres that stand as walls, by contact; those without are flat [r].
    std::vector<double> wallRadii;
    double rollingFriction = 0; ///< moment that resists rolling, over normal force and arm()

    /// The reduced radius of a contact [r].
    [[nodiscard]] double arm(std::size_t k) const
    {
        const double radius = bodies[contacts[k].upon].radius;
        if (contacts[k].from == kWall)
        {
            return k < wallRadii.size() ? radius / (1 + radius / wallRadii[k]) : radius;
        }
        return radius * bodies[contacts[k].from].radius /
               (radius + bodies[contacts[k].from].radius);
    }
};

/// The one by which the scene is judged.
[[nodiscard]] inline double rollingFrictionOf(const Scene& scene)
{
    return scene.judge.rollingFriction.value_or(scene.rest.rollingFriction);
}

/// Of all spheres at rest, by their rows. Two are in contact when the gap between them is below
/// kContactGap of the smaller radius; see forEachTriangleBeside for walls.
[[nodiscard]] ContactNetwork networkAtRest(const World& world, Threads& threads);

} // namespace frostfill
