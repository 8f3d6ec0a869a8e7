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

/// Height at which the first of the spheres is touched that lie in a layer of cells, in p's column
/// or one of the eight around it.
double contactInLayer(const World& world, const std::array<int, 3>& column, int layer,
                      const Eigen::Vector3d& p, double radius)
{
    double highest = -std::numeric_limits<double>::infinity();
    const std::array<int, 3>& count = world.spheres.resting().frame().count;
    const std::array<int, 3> low = {std::max(0, column[0] - 1), layer, std::max(0, column[2] - 1)};
    const std::array<int, 3> high = {std::min(count[0] - 1, column[0] + 1), layer,
                                     std::min(count[2] - 1, column[2] + 1)};
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachIn(low, high,
                      [&](std::uint32_t row)
                      {
                          const Ball& other = resting[row];
                          const double reach = radius + other.radius;
                          const double squared = squaredHeightOfTouch(other.position() - p, reach);
                          if (squared > 0 && p.y() - other.y > kSlides * reach)
                          {
                              highest =
                                  std::max(highest, std::min(p.y(), other.y + std::sqrt(squared)));
                          }
                      });
    return highest;
}

double sphereBelow(const World& world, const FallIndex& falls, const std::array<int, 3>& column,
                   const Eigen::Vector3d& p, double radius)
{
    const GridFrame& frame = falls.frame();
    double highest = -std::numeric_limits<double>::infinity();
    for (int layer = falls.highestSphere(column[0], column[2], column[1]); layer >= 0;)
    {
        highest = std::max(highest, contactInLayer(world, column, layer, p, radius));
        // Whatever lies in the layers below is touched lower than this.
        if (layer == 0 || highest >= frame.origin.y() + frame.cell * layer + radius + 1)
        {
            break;
        }
        layer = falls.highestSphere(column[0], column[2], layer - 1);
    }
    return highest;
}

/// How far a sphere can fall from `here`, at most to `end`, in a cell of the triangles' grid.
double fallInCell(const World& world, const std::array<int, 3>& cell, const Eigen::Vector3d& here,
                  double radius, double end)
{
    double path = here.y() - end;
    const auto castAt = [&](std::span<const std::uint32_t> triangles)
    {
        for (const std::uint32_t id : triangles)
        {
            if (world.polygons[id] == PolygonState::active &&
                world.surface.bound(id).mayBeWithin(radius + path, here))
            {
                path = castAtTriangle(world.surface, id, here, radius, {0, -1, 0}, path);
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

// Goes down cell by cell of the triangles' grid, past layers without a wall at once. Each cell has
// the triangles that can touch a sphere with its centre in it.
double wallBelow(const World& world, const FallIndex& falls, const std::array<int, 3>& column,
                 const Eigen::Vector3d& p, double radius, double lowest)
{
    const GridFrame& fine = world.triangles.frame();
    const GridFrame& coarse = falls.frame();
    const std::array<int, 3> fineColumn = fine.coordinates(p);
    Eigen::Vector3d here = p;
    for (int layer = column[1]; here.y() > lowest; --layer)
    {
        layer = falls.highestWall(column[0], column[2], layer);
        if (layer < 0)
        {
            break;
        }
        const double top = coarse.origin.y() + coarse.cell * (layer + 1);
        const double bottom = std::max(lowest, top - coarse.cell);
        here.y() = std::min(here.y(), top);
        while (here.y() > bottom)
        {
            const int y = fine.coordinate(here.y() - kJustBelow, 1);
            const double end = std::max(bottom, fine.origin.y() + fine.cell * y);
            const double path =
                fallInCell(world, {fineColumn[0], y, fineColumn[2]}, here, radius, end);
            if (path < here.y() - end)
            {
                return here.y() - path;
            }
            here.y() = end;
        }
        if (layer == 0)
        {
            break;
        }
    }
    return lowest;
}

} // namespace

std::optional<double> contactBelow(const World& world, const FallIndex& falls,
                                   const Eigen::Vector3d& p, double radius)
{
    const auto column = falls.frame().coordinates(p);
    const double sphere = sphereBelow(world, falls, column, p, radius);
    const double y = wallBelow(world, falls, column, p, radius, sphere);
    return std::isfinite(y) ? std::optional(y) : std::nullopt;
}

} // namespace frostfill
