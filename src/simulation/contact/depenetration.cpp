// SPDX-License-Identifier: MIT
#include "simulation/contact/depenetration.hpp"

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
};

// Returns false where p is outside the object.
bool pushOffWalls(const World& world, const Eigen::Vector3d& p, double radius, Push& push)
{
    const auto triangles = world.triangles.near(p);
    if (triangles.empty())
    {
        return world.inside.contains(p);
    }
    const SignedDistance wall = nearestDistance(world.surface, triangles, p);
    if (wall.value == 0 || wall.value < -radius)
    {
        return false;
    }
    if (radius - wall.value > push.depth)
    {
        push.depth = radius - wall.value;
        push.out = (p - wall.closest) / wall.value * (push.depth + kClearance);
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
        world.resting.forEachNear(p, radius + 1 + farthest,
                                  [&](std::uint32_t id)
                                  {
                                      const GridSphere& other = world.resting[id];
                                      add(other.position(), other.radius, p, radius, farthest);
                                  });
    }

    void add(const Eigen::Vector3d& centre, double its, const Eigen::Vector3d& p, double radius,
             double farthest)
    {
        const double limit = radius + its + farthest;
        if ((centre - p).squaredNorm() < limit * limit)
        {
            spheres_.push_back({centre, radius + its});
        }
    }

    void pushOff(const Eigen::Vector3d& p, Push& push) const
    {
        for (const auto& [centre, reach] : spheres_)
        {
            const Eigen::Vector3d d = p - centre;
            const double limit = reach - push.depth;
            const double squared = d.squaredNorm();
            if (squared < limit * limit)
            {
                const double distance = std::sqrt(squared);
                push.depth = reach - distance;
                // From the very centre every way out is as good.
                const Eigen::Vector3d way =
                    distance > 0 ? Eigen::Vector3d(d / distance) : Eigen::Vector3d::UnitY();
                push.out = way * (push.depth + kClearance);
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
