// SPDX-License-Identifier: MIT
#include "simulation/contact/depenetration.hpp"

#include "simulation/contact/contact.hpp"

#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

struct Push
{
    double depth = -kClearance / 2; ///< of the deepest overlap so far
    Eigen::Vector3d out = Eigen::Vector3d::Zero();

    void take(const Contact& contact)
    {
        depth = contact.depth;
        out = separationDirection(contact) * (depth + kClearance);
    }
};

// Returns false where p is outside the object.
bool pushOffWalls(const World& world, const Eigen::Vector3d& p, double radius, Push& push)
{
    const auto triangles = world.triangles.near(p);
    if (triangles.empty())
    {
        return world.inside.contains(p);
    }
    const SignedDistance wall = world.triangles.nearest(p, triangles);
    if (std::isinf(wall.value))
    {
        return world.inside.contains(p);
    }
    if (wall.value == 0 || wall.value < -radius ||
        (world.surface.anyTwoSided() && !world.inside.contains(p)))
    {
        return false;
    }
    const Contact contact = wallContact(wall, p, radius);
    if (contact.depth > push.depth)
    {
        push.take(contact);
    }
    return true;
}

/// Spheres at rest, listed once for all the moves from one place.
class Obstacles
{
public:
    void list(const World& world, const Eigen::Vector3d& p, double radius, double farthest)
    {
        spheres_.clear();
        const SphereGrid& resting = world.spheres.resting();
        resting.forEachNear(p, radius + 1 + farthest,
                            [&](std::uint32_t row)
                            {
                                const Ball& other = resting[row];
                                add(other.position(), other.radius, p, radius, farthest);
                            });
    }

    void add(const Eigen::Vector3d& centre, double its, const Eigen::Vector3d& p, double radius,
             double farthest)
    {
        if (isWithin(centre, p, radius + its + farthest))
        {
            spheres_.push_back({centre, radius + its});
        }
    }

    void pushOff(const Eigen::Vector3d& p, Push& push) const
    {
        for (const auto& [centre, reach] : spheres_)
        {
            if (const auto contact = sphereContact(p - centre, reach, -push.depth))
            {
                push.take(*contact); // deeper than all before
            }
        }
    }

private:
    struct Obstacle
    {
        Eigen::Vector3d centre;
        double reach = 0; ///< sum of the two radii
    };
    std::vector<Obstacle> spheres_;
};

bool depenetrateFrom(const World& world, const Obstacles& obstacles, Eigen::Vector3d& p,
                     double radius, double farthest, int moves)
{
    const Eigen::Vector3d start = p;
    for (int move = 0; move < moves; ++move)
    {
        Push push;
        if (!pushOffWalls(world, p, radius, push))
        {
            return false;
        }
        obstacles.pushOff(p, push);
        if (push.out.isZero(0))
        {
            return true;
        }
        p += push.out;
        if ((p - start).squaredNorm() > farthest * farthest)
        {
            return false;
        }
    }
    return false;
}

thread_local Obstacles obstacles; // keeps its memory

} // namespace

bool depenetrate(const World& world, Eigen::Vector3d& p, double radius, double farthest, int moves)
{
    obstacles.list(world, p, radius, farthest);
    return depenetrateFrom(world, obstacles, p, radius, farthest, moves);
}

bool depenetrate(const World& world, const PlacedSphere& newcomer, Eigen::Vector3d& p,
                 double radius, double farthest, int moves)
{
    obstacles.list(world, p, radius, farthest);
    obstacles.add(newcomer.place, newcomer.radius, p, radius, farthest);
    return depenetrateFrom(world, obstacles, p, radius, farthest, moves);
}

} // namespace frostfill
