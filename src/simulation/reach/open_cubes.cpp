// SPDX-License-Identifier: MIT
#include "simulation/reach/open_cubes.hpp"

#include "mesh/interior/near_surface.hpp"
#include "simulation/world/tolerances.hpp"

#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

// Takes the smallest edge from `voxel` on with which a set of cubes fits into memory. Returns
// nothing when that edge is longer than `largest`.
std::optional<Cubes> chooseCubes(const Surface& surface, const InsideTest& inside, double margin,
                                 double voxel, double largest, std::size_t bytes)
{
    for (; voxel <= largest;
         voxel = voxel < largest ? std::min(voxel * kCubeGrowth, largest) : 2 * voxel)
    {
        // In floating point, for the numbers of cubes may not fit an int.
        const double longest = surface.box().sizes().maxCoeff() + 2 * margin;
        if (longest / voxel + 68 > std::numeric_limits<int>::max())
        {
            continue;
        }
        const GridFrame frame = GridFrame::cover(surface.box(), voxel, margin + 2 * voxel);
        const auto most = static_cast<double>(bytes / sizeof(std::uint64_t));
        if (auto cubes = Cubes::inReach(frame, inside, most))
        {
            return cubes;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<OpenCubes> openCubesOf(const Surface& surface, const InsideTest& inside, double probe,
                                     std::size_t bytes, Threads& threads, CubeSet* unblocked)
{
    OpenCubes open;
    open.probe = probe;
    const double largest = kLargestVoxel * open.exclusion(probe);
    auto cubes =
        chooseCubes(surface, inside, probe, std::min(kReachVoxel * probe, largest), largest, bytes);
    if (!cubes)
    {
        return std::nullopt;
    }
    open.cubes = *std::move(cubes);
    const Cubes& all = open.cubes;
    CubeSet left = cubesFartherThan(
        surface, all, open.exclusion(probe) - kHalfDiagonal * all.frame().cell, all.all(), threads);
    if (unblocked != nullptr)
    {
        *unblocked = left;
    }
    open.inside = cubesInside(all, inside, std::move(left));
    return open;
}

} // namespace frostfill
