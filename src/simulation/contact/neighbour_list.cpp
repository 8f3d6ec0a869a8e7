// SPDX-License-Identifier: MIT
#include "simulation/contact/neighbour_list.hpp"

#include "simulation/contact/contact.hpp"

#include <algorithm>
#include <iterator>

namespace frostfill
{

void NeighbourList::ensure(const World& world, const Eigen::Vector3d& p, double radius,
                           double ahead)
{
    if (world.scene.search.neighbourLists && radius_ == radius && room(p) >= ahead)
    {
        return;
    }
    centre_ = p;
    radius_ = radius;
    x.clear();
    y.clear();
    z.clear();
    reach.clear();
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachNear(p, radius + 1 + kSkin,
                        [&](std::uint32_t row)
                        {
                            const Ball& other = resting[row];
                            const double contact = radius + other.radius;
                            if (isWithin(other.position(), p, contact + kSkin) &&
                                !resting.isDiscarded(row))
                            {
                                x.push_back(other.x);
                                y.push_back(other.y);
                                z.push_back(other.z);
                                reach.push_back(contact);
                            }
                        });
    const auto isNear = [&](std::uint32_t triangle)
    {
        return world.polygons[triangle] == PolygonState::active &&
               world.surface.bound(triangle).mayBeWithin(radius + kSkin, p);
    };
    const auto take = [&](std::span<const std::uint32_t> ids)
    { std::copy_if(ids.begin(), ids.end(), std::back_inserter(triangles_), isNear); };
    triangles_.clear();
    const std::span<const std::uint32_t> nearby = world.triangles.near(p);
    if (nearby.size() <= TriangleGrid::kShortList)
    {
        take(nearby);
        return;
    }
    // Where a cell has many, as in scans, the tree finds fewer.
    const double distance = radius + kSkin;
    world.surface.tree().forEachNear(Eigen::AlignedBox3d(p), distance,
                                     [&](std::span<const std::uint32_t> ids)
                                     {
                                         take(ids);
                                         return distance;
                                     });
    std::sort(triangles_.begin(), triangles_.end());
}

bool NeighbourList::add(const Eigen::Vector3d& p, double radius)
{
    const double contact = radius_ + radius;
    if (radius_ < 0 || !isWithin(p, centre_, contact + kSkin))
    {
        return false;
    }
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    reach.push_back(contact);
    return true;
}

} // namespace frostfill
