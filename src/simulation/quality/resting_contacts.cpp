// SPDX-License-Identifier: MIT
#include "simulation/quality/resting_contacts.hpp"

#include "simulation/quality/beside.hpp"
#include "simulation/quality/wall_pieces.hpp"

#include <vector>

namespace frostfill
{
namespace
{

std::uint32_t spheresBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    std::uint32_t count = 0;
    forEachSphereBeside(world.spheres.resting(), id, p, world.spheres.radius(id),
                        [&](std::uint32_t, const Eigen::Vector3d& apart, double)
                        { count += apart.isZero(0) ? 0 : 1; });
    return count;
}

std::uint32_t wallsBeside(const World& world, std::uint32_t id, const Eigen::Vector3d& p)
{
    const double reach = world.spheres.radius(id) * (1 + kContactGap);
    std::vector<std::uint32_t> nearby;
    return wallPieces(world.surface, world.triangles.near(p, reach, nearby), p, reach, kOnWall);
}

} // namespace

std::uint32_t restingContacts(const World& world, std::uint32_t id)
{
    const Eigen::Vector3d p = world.spheres.position(id);
    if (world.spheres.isRunning(id) || !p.allFinite())
    {
        return 0;
    }
    return spheresBeside(world, id, p) + wallsBeside(world, id, p);
}

} // namespace frostfill
