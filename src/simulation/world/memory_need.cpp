// SPDX-License-Identifier: MIT
#include "simulation/world/memory_need.hpp"

#include "simulation/world/tolerances.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// For each sphere: position, velocity, states [bytes]. In a cube, runs of a million take 131 with
/// their grids, of a hundred million 73.
constexpr double kMemoryPerSphere = 52;
/// For each cell of a radius: the grids and release sites [bytes].
constexpr double kMemoryPerCell = 1.1;
/// And the map of what is within reach, while it may have cubes that are small enough. In a cube of
/// 55 million cells, runs of a few spheres take 6.1 with all.
constexpr double kMapPerCell = 3.9;
/// And near walls: lists of triangles, bricks that are partly in use. In a frame of bars, runs of a
/// few spheres take 50 with 11 million of such cells.
constexpr double kMemoryPerWallCell = 20;
/// By which a radius grows until its spheres have room. Larger: larger radii are named than needed.
constexpr double kRadiusGrowth = 1.001;

} // namespace

double ObjectSize::wallCells() const
{
    return 2 * kTriangleReach * area;
}

double ObjectSize::cells() const
{
    return std::min((box.array() + 2 * kGridMargin).prod(), volume + wallCells());
}

double memoryNeed(const ObjectSize& object, double spheres)
{
    const double cells = object.cells();
    const double walls = kMemoryPerWallCell * std::min(cells, object.wallCells());
    const double map = std::min(kMapPerCell * cells, static_cast<double>(kMostMapBytes));
    return kMemoryPerSphere * spheres + kMemoryPerCell * cells + map + walls;
}

void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   const MemoryAtHand& memory)
{
    // What is too large for any memory is refused as that.
    const bool isTooLarge = ObjectSize(object, radius).cells() > kMaxCells;
    if ((isTooLarge ? kMemoryPerSphere * spheres
                    : memoryNeed(ObjectSize(object, radius), spheres)) <= memory.bytes)
    {
        return;
    }
    // A full object of the smallest spheres that there is memory for.
    double room = radius;
    while (room < object.box.sizes().maxCoeff() &&
           memoryNeed(ObjectSize(object, room), ObjectSize(object, room).volume) > memory.bytes)
    {
        room *= kRadiusGrowth;
    }
    throw Error(
        ErrorCode::outOfMemory,
        fmt::format("spheres of radius {:.3g} in {} take more than the {:.3g} GB of memory {}; "
                    "take a --radius of {:.2g} or more",
                    radius, scene.object.mesh, memory.bytes / 1e9, memory.bound, room));
}

} // namespace frostfill
