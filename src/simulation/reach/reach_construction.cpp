// SPDX-License-Identifier: MIT
#include "mesh/interior/near_surface.hpp"
#include "simulation/reach/reach_leak.hpp"
#include "simulation/reach/reach_map.hpp"
#include "simulation/reach/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

GridFrame frameAbout(const Surface& surface, double margin, double voxel)
{
    return GridFrame::cover(surface.box(), voxel, margin + 2 * voxel);
}

// With cubes of the given edge, if its sets of cubes fit into memory.
std::optional<VoxelLayout> layoutOf(const Surface& surface, const InsideTest& inside, double margin,
                                    double voxel, const ReachMap::Resolution& limits)
{
    // In floating point, for the numbers of cubes may not fit an int.
    const Eigen::Vector3d box = surface.box().sizes();
    const Eigen::Array3d count =
        (box.array() + 2 * margin) / voxel + Eigen::Array3d(68, 6, 6); // with all padding
    if (count.maxCoeff() > std::numeric_limits<int>::max())
    {
        return std::nullopt;
    }
    const GridFrame frame = frameAbout(surface, margin, voxel);
    const double whole = count.prod() * (kSetsOfCubes / 8.0);
    if (whole > static_cast<double>(std::min(limits.wholeGrid, limits.bytes)))
    {
        constexpr std::size_t kBytesOfWord =
            std::size_t{8} * kSetsOfCubes + VoxelBricks::kBytesOfBrick / VoxelBricks::kInBrick;
        const auto bricks = VoxelBricks::inReach(frame, inside, limits.bytes / kBytesOfWord);
        return bricks ? std::optional(VoxelLayout(frame, bricks)) : std::nullopt;
    }
    return VoxelLayout(frame);
}

// The smallest edge from `voxel` on whose sets of cubes fit into memory; nothing when that is more
// than `largest`.
std::optional<VoxelLayout> chooseLayout(const Surface& surface, const InsideTest& inside,
                                        double margin, double voxel, double largest,
                                        const ReachMap::Resolution& limits)
{
    for (; voxel <= largest;
         voxel = std::min(voxel * kGrowth, std::max(largest, voxel * kMinGrowth)))
    {
        if (auto layout = layoutOf(surface, inside, margin, voxel, limits))
        {
            return layout;
        }
    }
    return std::nullopt;
}

} // namespace

ReachMap::ReachMap(const Surface& surface, const InsideTest& inside, const Radii& radii,
                   const Margins& margins, const Resolution& resolution, Unblocked* unblocked)
    : surface_(surface), radii_(radii), margins_(margins)
{
    const double largest = kLargestVoxel * exclusion(radii.smallest);
    const double voxel = std::min(resolution.voxel * radii.smallest, largest);
    const auto layout =
        largest > 0 ? chooseLayout(surface, inside, radii.smallest, voxel, largest, resolution)
                    : std::nullopt;
    active_ = layout.has_value();
    if (!active_)
    {
        return;
    }
    layout_ = *layout;
    search_ = VoxelFlood(layout_);
    open_ = unblockedCubes();
    if (unblocked != nullptr)
    {
        unblocked->all = open_;
    }
    marks_ = SparseVoxelBits(layout_.words);
    keepInside(inside);
    reachedCount_ = countCubes(open_);
    search_.releaseMemory();
    if (unblocked != nullptr)
    {
        unblocked->inside = open_;
    }
}

double ReachMap::exclusion(double contact) const
{
    const double least = contact - margins_.overlap;
    const double square = least * least - margins_.step * margins_.step / 4;
    return least > 0 && square > 0 ? std::max(0.0, std::sqrt(square) - kReachRounding) : 0;
}

VoxelBits ReachMap::unblockedCubes() const
{
    VoxelBits all(layout_.words, 0);
    layout_.forEachWord([&](VoxelWord w) { all[w.word] |= w.bits; });
    return cubesFartherThan(exclusion(radii_.smallest) - kHalfDiagonal * layout_.frame.cell,
                            std::move(all));
}

VoxelBits ReachMap::cubesFartherThan(double distance, VoxelBits among) const
{
    // Where triangles are small, most rows have been closed by their neighbours.
    const auto closeIn = [&](int y, int z, CellRun run, auto&& isNear)
    {
        layout_.findInRow(among, y, z, run.first, run.last,
                          [&](int x, VoxelWord cube)
                          {
                              if (isNear(x))
                              {
                                  among[cube.word] &= ~cube.bits;
                              }
                              return false;
                          });
    };
    forEachGroup(surface_, layout_.frame.cell,
                 [&](const TriangleGroup& group)
                 {
                     forEachRunNear(
                         layout_.frame, surface_, group, distance, closeIn,
                         [&](int y, int z, int last, CellRun most)
                         { return layout_.firstRow(among, y, z, last, most.first, most.last); });
                 });
    return among;
}

// Cubes that are connected lie on the same side of the surface: one test serves a whole component.
// Those at the border are outside, unless the surface has a hole.
void ReachMap::keepInside(const InsideTest& inside)
{
    layout_.forEachOutermost([&](VoxelWord cubes)
                             { search_.run(open_, cubes, [](VoxelWord) { return false; }); });
    VoxelBits outer(layout_.words, 0);
    search_.drain([&](VoxelWord w) { outer[w.word] = w.bits; });
    leak_ = findLeak(surface_, inside, layout_, outer, radii_.smallest);
    if (leak_)
    {
        active_ = false;
        return;
    }
    VoxelBits left = std::move(open_);
    open_.assign(layout_.words, 0);
    for (std::size_t word = 0; word < left.size(); ++word)
    {
        left[word] &= ~outer[word];
        while (left[word] != 0)
        {
            const VoxelWord first{word, left[word] & -left[word]};
            search_.run(left, first, [](VoxelWord) { return false; });
            bool isInside = false;
            layout_.forEachCube(first, [&](int x, int y, int z)
                                { isInside = inside.contains(layout_.frame.centre(x, y, z)); });
            search_.drain(
                [&](VoxelWord w)
                {
                    left[w.word] &= ~w.bits;
                    open_[w.word] |= isInside ? w.bits : 0;
                });
        }
    }
}

} // namespace frostfill
