// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_leak.hpp"
#include "simulation/reach/reach_map.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/reach/voxel_rows.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

GridFrame frameAbout(const Surface& surface, double margin, double voxel)
{
    return GridFrame::cover(surface.box(), voxel, margin + 2 * voxel);
}

// The smallest edge from `voxel` on whose sets of cubes fit into memory; nothing when that is more
// than `largest`.
std::optional<VoxelLayout> chooseLayout(const Surface& surface, double margin, double voxel,
                                        double largest, std::size_t bytes)
{
    const auto size = [&](double edge)
    {
        // In floating point, for the numbers of cubes may not fit an int.
        const Eigen::Vector3d box = surface.box().sizes();
        const Eigen::Array3d count =
            (box.array() + 2 * margin) / edge + Eigen::Array3d(68, 6, 6); // with all padding
        return count.prod() * (kSetsOfCubes / 8.0);
    };
    for (; voxel <= largest;
         voxel = std::min(voxel * kGrowth, std::max(largest, voxel * kMinGrowth)))
    {
        if (size(voxel) <= static_cast<double>(bytes))
        {
            return VoxelLayout(frameAbout(surface, margin, voxel));
        }
    }
    return std::nullopt;
}

std::size_t countCubes(const VoxelBits& set)
{
    std::size_t count = 0;
    for (const std::uint64_t word : set)
    {
        count += static_cast<std::size_t>(std::popcount(word));
    }
    return count;
}

} // namespace

ReachMap::ReachMap(const Surface& surface, const InsideTest& inside, const Radii& radii,
                   const Margins& margins, const Resolution& resolution)
    : surface_(surface), radii_(radii), margins_(margins)
{
    const double largest = kLargestVoxel * exclusion(radii.smallest);
    const double voxel = std::min(resolution.voxel * radii.smallest, largest);
    const auto layout =
        largest > 0 ? chooseLayout(surface, radii.smallest, voxel, largest, resolution.bytes)
                    : std::nullopt;
    active_ = layout.has_value();
    if (!active_)
    {
        return;
    }
    layout_ = *layout;
    search_ = VoxelFlood(layout_);
    open_ = unblockedCubes();
    marks_.assign(layout_.words, 0);
    triangleCursor_.assign(surface.size(), 0);
    keepInside(inside);
    reachedCount_ = countCubes(open_);
    seeds_ = open_;
}

double ReachMap::exclusion(double contact) const
{
    const double least = contact - margins_.overlap;
    const double square = least * least - margins_.step * margins_.step / 4;
    return least > 0 && square > 0 ? std::max(0.0, std::sqrt(square) - kReachRounding) : 0;
}

VoxelBits ReachMap::cubesFartherThan(double distance) const
{
    VoxelBits open(layout_.words, 0);
    const auto& count = layout_.frame.count;
    for (int y = 0; y < count[1]; ++y)
    {
        for (int z = 0; z < count[2]; ++z)
        {
            layout_.forEachWord(y, z, 0, count[0] - 1,
                                [&](VoxelWord w) { open[w.word] |= w.bits; });
        }
    }
    for (std::uint32_t id = 0; id < surface_.size(); ++id)
    {
        const TriangleRows rows(layout_.frame, surface_, id, distance);
        const VoxelRun widest = rows.widest();
        if (widest.first > widest.last)
        {
            continue;
        }
        rows.window().forEach(
            [&](int y, int z)
            {
                // Where triangles are small, most rows have been closed by their neighbours.
                if (!layout_.any(open, y, z, widest.first, widest.last))
                {
                    return;
                }
                const VoxelRun run = rows.run(y, z);
                for (int x = run.first; x <= run.last; ++x)
                {
                    const VoxelWord cube = layout_.at(x, y, z);
                    if ((open[cube.word] & cube.bits) != 0 && rows.near(x, y, z))
                    {
                        open[cube.word] &= ~cube.bits;
                    }
                }
            });
    }
    return open;
}

// Cubes that are connected lie on the same side of the surface: one test serves a whole component.
// The one at the border is outside, unless the surface has a hole.
void ReachMap::keepInside(const InsideTest& inside)
{
    search_.run(open_, layout_.at(0, 0, 0), [](VoxelWord) { return false; });
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
