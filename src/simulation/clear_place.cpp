// SPDX-License-Identifier: MIT
#include <simulation/clear_place.hpp>

namespace frostfill
{
namespace
{

constexpr int kMoves = 24;

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

void pushOffSpheres(const World& world, const Eigen::Vector3d& p, double radius, Push& push)
{
    world.resting.forEachNear(p, radius + 1,
                              [&](std::uint32_t id)
                              {
                                  const GridSphere& other = world.resting[id];
                                  const Eigen::Vector3d d = p - other.position();
                                  const double distance = d.norm();
                                  const double depth = radius + other.radius - distance;
                                  if (depth > push.depth && distance > 0)
                                  {
                                      push.depth = depth;
                                      push.out = d / distance * (depth + kClearance);
                                  }
                              });
}

} // namespace

bool moveClear(const World& world, Eigen::Vector3d& p, double radius, double farthest)
{
    const Eigen::Vector3d start = p;
    for (int move = 0; move < kMoves; ++move)
    {
        Push push;
        if (!pushOffWalls(world, p, radius, push))
        {
            return false;
        }
        pushOffSpheres(world, p, radius, push);
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

} // namespace frostfill
