// SPDX-License-Identifier: MIT
#include "simulation/contact/depenetration.hpp"

#include "simulation/contact/contact.hpp"

#include <cmath>
#include <limits>
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

// Returns false where p is outside the object. Where its side is known, only a wall that may push
// matters.
bool pushOffWalls(const World& world, const Eigen::Vector3d& p, double radius, bool isInside,
                  Push& push)
{
    const auto triangles = world.triangles.near(p);
    if (triangles.empty())
    {
        return isInside || world.inside.contains(p);
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const SignedDistance wall =
        world.triangles.nearest(p, triangles, isInside ? radius + kClearance : kInfinity);
    if (std::isinf(wall.value))
    {
        return isInside || world.inside.contains(p);
    }
    if (wall.value == 0 || wall.value < -radius ||
        (world.surface.anyTwoSided() && !world.inside.contains(p, wall)))
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

// Where no wall is within a radius, the whole way of a move to there that is shorter than that has
// none: both its ends are on one side.
bool depenetrateFrom(const World& world, const Obstacles& obstacles, Eigen::Vector3d& p,
                     double radius, double farthest, int moves, bool isInside)
{
    const bool sidesAreKnown = !world.surface.anyTwoSided();
    const Eigen::Vector3d start = p;
    for (int move = 0; move < moves; ++move)
    {
        Push push;
        if (!pushOffWalls(world, p, radius, isInside && sidesAreKnown, push))
        {
            return false;
        }
        obstacles.pushOff(p, push);
        if (push.out.isZero(0))
        {
            return true;
        }
        p += push.out;
        isInside = push.out.squaredNorm() < radius * radius;
        if ((p - start).squaredNorm() > farthest * farthest)
        {
            return false;
        }
    }
    return false;
}

thread_local Obstacles obstacles; // keeps its memory

} // namespace

void gather(SphereGrid& grid, const RunningSpheres& running)
{
    grid.clear();
    for (std::uint32_t row = 0; row < running.size(); ++row)
    {
        grid.insert(row, running.position[row], running.radius[row]);
    }
}

bool isClearOf(const SphereGrid& grid, const Eigen::Vector3d& place, double radius)
{
    bool clear = true;
    grid.forEachNear(place, radius + 1 + kClearance,
                     [&](std::uint32_t row)
                     {
                         const Ball& other = grid[row];
                         clear = clear && !isWithin(other.position(), place,
                                                    other.radius + radius + kClearance);
                     });
    return clear;
}

bool depenetrate(const World& world, Eigen::Vector3d& p, double radius, double farthest, int moves,
                 Start start)
{
    obstacles.list(world, p, radius, farthest);
    return depenetrateFrom(world, obstacles, p, radius, farthest, moves, start == Start::inside);
}

bool depenetrate(const World& world, const PlacedSphere& newcomer, Eigen::Vector3d& p,
                 double radius, double farthest, int moves)
{
    obstacles.list(world, p, radius, farthest);
    obstacles.add(newcomer.place, newcomer.radius, p, radius, farthest);
    return depenetrateFrom(world, obstacles, p, radius, farthest, moves, false);
}

} // namespace frostfill
