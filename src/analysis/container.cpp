// SPDX-License-Identifier: MIT
#include "analysis/container.hpp"

#include "simulation/quality/contact_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// Cells along the longest side of the grid that tells inside from outside. Larger: memory grows
/// with its square. Smaller: more places are near a wall and take longer.
constexpr double kMostCells = 256;

GridFrame gridFor(const Surface& surface, double length)
{
    const double cell = std::max(length, surface.box().sizes().maxCoeff() / kMostCells);
    return GridFrame::cover(surface.box(), cell, 2 * cell);
}

} // namespace

Container::Container(const TriangleMesh& mesh, double length)
    : report_(inspectInterior(mesh)), surface_(mesh),
      grid_(surface_, gridFor(surface_, length), gridFor(surface_, length).cell / 2),
      inside_(surface_, grid_)
{
}

double Container::distanceToWall(const Eigen::Vector3d& p, double limit) const
{
    const auto wall = nearestPoint(surface_.mesh(), surface_.tree(), p, limit);
    return wall ? wall->distance : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d Container::nearestWallPoint(const Eigen::Vector3d& p) const
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return nearestPoint(surface_.mesh(), surface_.tree(), p, kInfinity)->point;
}

std::uint32_t Container::wallsWithin(const Eigen::Vector3d& p, double reach) const
{
    std::vector<std::uint32_t> near;
    surface_.tree().findNear(p, reach, near);
    return wallPieces(surface_, near, p, reach, 0);
}

} // namespace frostfill
