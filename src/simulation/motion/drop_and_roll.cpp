// SPDX-License-Identifier: MIT
#include "simulation/motion/drop_and_roll.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "simulation/motion/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace frostfill
{

namespace
{

/// Height at which the first sphere at rest is touched: looks into each layer of cells below p,
/// level by level of their grid.
double sphereBelow(const World& world, const Eigen::Vector3d& p, double radius)
{
    const SphereGrid& resting = world.spheres.resting();
    double highest = -std::numeric_limits<double>::infinity();
    const auto meet = [&](std::uint32_t row)
    {
        const Ball& other = resting[row];
        const double contact = radius + other.radius;
        const double squared = squaredHeightOfTouch(other.position() - p, contact);
        if (squared > 0 && p.y() - other.y > kSlides * contact)
        {
            highest = std::max(highest, std::min(p.y(), other.y + std::sqrt(squared)));
        }
    };
    for (std::size_t level = 0; level < resting.levels(); ++level)
    {
        const GridFrame& frame = resting.frame(level);
        const double reach = radius + resting.largest(level);
        const int beside = static_cast<int>(std::ceil(reach / frame.cell));
        const auto [x, y, z] = frame.coordinates(p);
        const int top = frame.coordinate(resting.top(level), 1); // a fall begins far above it
        for (int layer = std::min(y, top); layer >= 0; --layer)
        {
            // Whatever lies in this layer and below is touched lower than at its top and the reach.
            if (highest >= frame.origin.y() + frame.cell * (layer + 1) + reach)
            {
                break;
            }
            resting.forEachIn({std::max(0, x - beside), layer, std::max(0, z - beside)},
                              {std::min(frame.count[0] - 1, x + beside), layer,
                               std::min(frame.count[2] - 1, z + beside)},
                              meet, level);
        }
    }
    return highest;
}

/// How far a sphere can fall from `here`, at most to `end`, in a cell of the triangles' grid.
double fallInCell(const World& world, const std::array<int, 3>& cell, const Eigen::Vector3d& here,
                  double radius, double end)
{
    const Eigen::Vector3d down(0, -1, 0);
    double path = here.y() - end;
    const auto castAt = [&](std::span<const std::uint32_t> triangles)
    {
        for (const std::uint32_t id : triangles)
        {
            if (mayTouch(world.surface.bound(id), here, radius, down, path))
            {
                path = castAtTriangle(world.surface, id, here, radius, down, path);
            }
        }
        return radius;
    };
    const auto ofCell = world.triangles.cell(cell[0], cell[1], cell[2]);
    if (ofCell.size() <= TriangleGrid::kShortList)
    {
        castAt(ofCell);
    }
    else
    {
        const Eigen::Vector3d last(here.x(), end, here.z());
        world.surface.tree().forEachNear(Eigen::AlignedBox3d(last, here), radius, castAt);
    }
    return path;
}

// Goes down cell by cell of the triangles' grid, and past bricks of cells without triangles at
// once. Each cell has the triangles that can touch a sphere with its centre in it.
double wallBelow(const World& world, const Eigen::Vector3d& p, double radius, double lowest)
{
    constexpr int kSide = TriangleGrid::Cells::kSide;
    const GridFrame& frame = world.triangles.frame();
    const BrickTable& bricks = world.triangles.cells().bricks();
    const int x = frame.coordinate(p.x(), 0);
    const int z = frame.coordinate(p.z(), 2);
    Eigen::Vector3d here = p;
    for (int y = frame.coordinate(p.y() - kTouch, 1); y >= 0 && here.y() > lowest; --y)
    {
        const bool isFree = bricks.find(x / kSide, y / kSide, z / kSide) == BrickTable::kNone;
        y -= isFree ? y % kSide : 0;
        const double end = std::max(lowest, frame.origin.y() + frame.cell * y);
        const double path =
            isFree ? here.y() - end : fallInCell(world, {x, y, z}, here, radius, end);
        if (path < here.y() - end)
        {
            return here.y() - path;
        }
        here.y() = end;
    }
    return lowest;
}

} // namespace

bool DropAndRoll::settle(Eigen::Vector3d& p, double radius, NeighbourList& around, double farthest,
                         Eigen::AlignedBox3d* seen) const
{
    const Path path{radius, around, seen};
    const Eigen::Vector3d start = p;
    double longest = kLongestSlide * radius;
    const bool sizesDiffer = world_.radii.curve().has_value();
    const double shortestLook = kShortestLook * (sizesDiffer ? std::min(1.0, 2 * radius) : 1);
    thread_local std::vector<Eigen::Vector3d> normals; // keeps its memory
    // A path loses height with every step, so it ends; the bound is for wedges that Newton's method
    // enters ever more slowly.
    const auto bound =
        static_cast<std::uint64_t>(kStepsPerRadiusOfHeight * (10 + world_.height / radius));
    for (std::uint64_t step = 0; step < bound; ++step)
    {
        look(path, p, shortestLook);
        p += contactNormals(world_.surface, around, p, radius, kTouch, normals);
        const Eigen::Vector3d down = world_.pull.direction(p);
        const Eigen::Vector3d pull = projectToFree(down, normals);
        if (pull.norm() <= kSettled)
        {
            return true; // carried: see isCarried, which has no use for the pull
        }
        if (!(normals.empty() ? fall(p, path, down) : slide(p, path, down, pull, longest)))
        {
            return false;
        }
        if ((p - start).squaredNorm() > farthest * farthest)
        {
            return false;
        }
    }
    return false;
}

// A list that is up to date was looked for before, and is in the box already.
void DropAndRoll::look(const Path& path, const Eigen::Vector3d& p, double ahead) const
{
    const bool anew = path.around.ensure(world_, p, path.radius, ahead);
    if (anew && path.seen != nullptr)
    {
        addSeen(*path.seen, p, path.radius + NeighbourList::kSkin);
    }
}

bool DropAndRoll::fall(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down) const
{
    if (down.y() == -1)
    {
        return drop(p, path.radius, path.seen);
    }
    p += sphereCast(world_.surface, path.around, p, path.radius, down, path.around.room(p)) * down;
    return true;
}

// Exact for spheres; walls to 1e-10 r.
bool DropAndRoll::drop(Eigen::Vector3d& p, double radius, Eigen::AlignedBox3d* seen) const
{
    const double y = wallBelow(world_, p, radius, sphereBelow(world_, p, radius));
    if (seen != nullptr)
    {
        addSeen(*seen, p, radius);
        addSeen(*seen, {p.x(), y, p.z()}, radius);
    }
    const bool isStopped = std::isfinite(y);
    p.y() = isStopped ? y : p.y();
    return isStopped;
}

// A straight part along the pull, then back to the contact that curves away from it. Both lose
// height: the second leads against the contacts' forces, whose sum points up.
bool DropAndRoll::slide(Eigen::Vector3d& p, const Path& path, const Eigen::Vector3d& down,
                        const Eigen::Vector3d& pull, double& longest) const
{
    const auto& [radius, around, seen] = path;
    const double weight = pull.norm();
    const Eigen::Vector3d along = pull / weight;
    // Near the bottom of a curve the pull fades with the distance to it.
    const double length = std::min({longest, kBeyondTheBottom * weight * radius, around.room(p)});
    const double gone = sphereCast(world_.surface, around, p, radius, along, length);
    p += gone * along;

    const Eigen::Vector3d forces = pull - down;
    const double force = forces.norm();
    if (force > kSettled)
    {
        // A contact that curves away is behind by about the square of the part.
        look(path, p, gone * gone / radius);
        const Eigen::Vector3d back = -forces / force;
        const double limit = std::min(kRegain * radius, around.room(p));
        const double regained = sphereCast(world_.surface, around, p, radius, back, limit);
        if (regained < limit)
        {
            p += regained * back;
        }
    }
    if (gone < kShortestSlide * weight * radius)
    {
        longest /= 2;
        return longest > kShortestSlide * radius;
    }
    longest = kLongestSlide * radius;
    return true;
}

} // namespace frostfill
