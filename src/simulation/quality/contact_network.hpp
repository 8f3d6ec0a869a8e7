// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/world/world.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

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
