// SPDX-License-Identifier: MIT
#include "simulation/motion/vertical_drop.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "simulation/motion/tolerances.hpp"

#include <algorithm>
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
    for (int y = frame.coordinate(p.y() - kJustBelow, 1); y >= 0 && here.y() > lowest; --y)
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

std::optional<double> contactBelow(const World& world, const Eigen::Vector3d& p, double radius)
{
    const double y = wallBelow(world, p, radius, sphereBelow(world, p, radius));
    return std::isfinite(y) ? std::optional(y) : std::nullopt;
}

} // namespace frostfill
