// SPDX-License-Identifier: MIT
#include "simulation/contact/neighbour_list.hpp"

#include "simulation/contact/contact.hpp"

#include <algorithm>
#include <iterator>

namespace frostfill
{
namespace
{

/// A small sphere moves by less than a large one, and has more around it within the same skin.
double skinOf(const World& world, double radius, double ahead)
{
    constexpr double kSkin = NeighbourList::kSkin;
    constexpr double kBeyondAhead = 1.5;
    constexpr double kOwnRadii = 2;
    return world.radii.curve() ? std::min(kSkin, std::max(kOwnRadii * radius, kBeyondAhead * ahead))
                               : kSkin;
}

} // namespace

bool NeighbourList::ensure(const World& world, const Eigen::Vector3d& p, double radius,
                           double ahead)
{
    if (world.scene.search.neighbourLists && radius_ == radius && room(p) >= ahead)
    {
        return false;
    }
    centre_ = p;
    radius_ = radius;
    skin_ = skinOf(world, radius, ahead);
    spheres_.clear();
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachNear(p, radius + 1 + skin_,
                        [&](std::uint32_t row)
                        {
                            const Ball& other = resting[row];
                            const double contact = radius + other.radius;
                            if (isWithin(other.position(), p, contact + skin_))
                            {
                                spheres_.push_back({other.x, other.y, other.z, contact});
                            }
                        });
    listTriangles(world, p, radius + skin_);
    return true;
}

void NeighbourList::listTriangles(const World& world, const Eigen::Vector3d& p, double distance)
{
    triangles_.clear();
    dense_ = nullptr;
    const auto take = [&](std::uint32_t triangle)
    {
        if (world.surface.bound(triangle).mayBeWithin(distance, p))
        {
            triangles_.push_back(triangle);
        }
    };
    const std::span<const std::uint32_t> nearby = world.triangles.near(p);
    if (nearby.size() <= TriangleGrid::kShortList)
    {
        std::for_each(nearby.begin(), nearby.end(), take);
        return;
    }
    const auto takeUnlessMany = [&](std::uint32_t triangle)
    {
        take(triangle);
        return triangles_.size() > kMostListed ? -1 : distance;
    };
    world.surface.tree().forEachTriangleNear(p, distance, takeUnlessMany);
    if (triangles_.size() > kMostListed)
    {
        dense_ = &world.surface; // what was found so far is not all
        return;
    }
    std::sort(triangles_.begin(), triangles_.end());
}

void NeighbourList::findInTree(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                               double distance)
{
    triangles_.clear();
    const auto take = [this](std::uint32_t triangle) { triangles_.push_back(triangle); };
    dense_->tree().forEachTriangleOnWay(from, to, distance, take);
    std::sort(triangles_.begin(), triangles_.end());
}

bool NeighbourList::add(const Eigen::Vector3d& p, double radius)
{
    const double contact = radius_ + radius;
    if (radius_ < 0 || !isWithin(p, centre_, contact + skin_))
    {
        return false;
    }
    spheres_.push_back({p.x(), p.y(), p.z(), contact});
    return true;
}

} // namespace frostfill
