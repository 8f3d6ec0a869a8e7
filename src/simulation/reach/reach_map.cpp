// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_map.hpp"

#include "simulation/reach/voxel_rows.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
void ReachMap::replaceSeeds(VoxelBits seeds)
{
    if (flooded_)
    {
        for (std::size_t word = 0; word < seeds.size(); ++word)
        {
            const std::uint64_t gone = seeds_[word] & ~seeds[word] & open_[word];
            if (gone != 0)
            {
                unseeded_.push_back({word, gone});
            }
        }
    }
    seeds_ = std::move(seeds);
}

void ReachMap::seedEverywhere()
{
    if (active_)
    {
        replaceSeeds(open_);
    }
}

void ReachMap::seedAbove(double height)
{
    if (!active_)
    {
        return;
    }
    const double rows = (height - layout_.frame.origin.y()) / layout_.frame.cell - kRounding;
    const double planes = std::clamp(std::ceil(rows), 0.0, layout_.frame.count[1] + 1.0);
    VoxelBits seeds = open_;
    // Plane y of the grid is plane y + 1 of the layout and ends at (y + 1) cubes.
    const std::size_t below = static_cast<std::size_t>(planes) * layout_.wordsPerPlane;
    std::fill(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(below), 0);
    replaceSeeds(std::move(seeds));
}

void ReachMap::setSeeds(std::span<const Eigen::Vector3d> points, double distance)
{
    if (!active_)
    {
        return;
    }
    VoxelBits seeds(layout_.words, 0);
    for (const Eigen::Vector3d& p : points)
    {
        const BallRows rows(layout_.frame, p, distance + kRounding, kMeetsBall);
        rows.window().forEach(
            [&](int y, int z)
            {
                const VoxelRun run = rows.run(y, z);
                if (run.first <= run.last)
                {
                    layout_.forEachWord(y, z, run.first, run.last,
                                        [&](VoxelWord w) { seeds[w.word] |= w.bits; });
                }
            });
    }
    replaceSeeds(std::move(seeds));
}

void ReachMap::withdrawSeeds()
{
    if (active_)
    {
        replaceSeeds(VoxelBits(layout_.words, 0));
    }
}

void ReachMap::withdrawSeed(const Eigen::Vector3d& p)
{
    if (!active_)
    {
        return;
    }
    const VoxelWord cube = layout_.at(p);
    if (flooded_ && (seeds_[cube.word] & cube.bits) != 0)
    {
        unseeded_.push_back(cube);
    }
    seeds_[cube.word] &= ~cube.bits;
}

void ReachMap::addResting(const Eigen::Vector3d& centre, double radius)
{
    if (!active_)
    {
        return;
    }
    const BallRows rows(layout_.frame, centre, exclusion(radius + radii_.smallest), kInsideBall);
    const VoxelRun widest = rows.widest();
    if (widest.first > widest.last)
    {
        return;
    }
    rows.window().forEach(
        [&](int y, int z)
        {
            // Most rows that a sphere at rest meets have been closed by its neighbours.
            if (!layout_.any(open_, y, z, widest.first, widest.last))
            {
                return;
            }
            const VoxelRun run = rows.run(y, z);
            if (run.first <= run.last)
            {
                layout_.forEachWord(y, z, run.first, run.last, [&](VoxelWord w) { block(w); });
            }
        });
}

void ReachMap::block(VoxelWord cubes)
{
    const std::uint64_t bits = open_[cubes.word] & cubes.bits;
    if (bits == 0)
    {
        return;
    }
    open_[cubes.word] &= ~bits;
    mark({cubes.word, bits});
}

bool ReachMap::contains(const Eigen::Vector3d& p) const
{
    if (!active_)
    {
        return true;
    }
    const VoxelWord cube = layout_.at(p);
    return (open_[cube.word] & cube.bits) != 0;
}

bool ReachMap::reaches(const Eigen::Vector3d& p, double distance) const
{
    if (!active_)
    {
        return true;
    }
    Cursor fromTheTop = 0;
    return findNearSphere(p, distance + kRounding, fromTheTop, [](int, int, int) { return true; });
}

} // namespace frostfill
