// SPDX-License-Identifier: MIT
#include "simulation/freezing/support_at_rest.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/motion/rolling.hpp"

#include <algorithm>

namespace frostfill
{

void SupportAtRest::findTouching(std::uint32_t id, std::vector<std::uint32_t>& found) const
{
    const Eigen::Vector3d place = world_.spheres.position(id);
    const double radius = world_.spheres.radius(id);
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(
        place, radius + 1 + kCarryingGap,
        [&](std::uint32_t row)
        {
            const Ball& near = resting[row];
            if (isWithin(near.position(), place, radius + near.radius + kCarryingGap))
            {
                found.push_back(resting.id(row));
            }
        });
}

bool SupportAtRest::carries(std::uint32_t id)
{
    const Eigen::Vector3d place = world_.spheres.position(id);
    const double radius = world_.spheres.radius(id);
    const double gap = kCarryingGap * radius;
    double lever = 1;
    normals_.clear();
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(place, radius + 1 + gap,
                        [&](std::uint32_t row)
                        {
                            const Ball& near = resting[row];
                            const auto contact =
                                sphereContact(place - near.position(), radius + near.radius, gap);
                            if (row != world_.spheres.row(id) && contact)
                            {
                                normals_.push_back(contact->normal);
                                lever = std::min(lever, near.radius / (radius + near.radius));
                            }
                        });
    for (const std::uint32_t t : world_.triangles.near(place, radius + gap, nearby_))
    {
        if (const auto contact = frontContact(world_.surface, t, place, radius, gap))
        {
            addNormal(normals_, contact->normal);
        }
    }
    const Eigen::Vector3d down = world_.pull.direction(place);
    return isCarried(down, normals_, kCarried) ||
           holdsStanding(RollingLaw::of(world_.scene), down, normals_, lever);
}

void SupportAtRest::sortOut(std::vector<std::uint32_t>& ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

} // namespace frostfill
