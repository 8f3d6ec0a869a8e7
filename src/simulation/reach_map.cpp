// SPDX-License-Identifier: MIT
#include <simulation/reach_map.hpp>

#include <simulation/voxel_rows.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kHalfDiagonal = 0.8660254037844387; // of a unit cube
constexpr double kRounding = 1e-9; // [r], above the rounding of any coordinate, on the safe side

} // namespace

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
        for (std::uint32_t row = 0; row < rows.window().size(); ++row)
        {
            const VoxelRun run = rows.run(row);
            if (run.first <= run.last)
            {
                layout_.forEachWord(run.y, run.z, run.first, run.last,
                                    [&](VoxelWord w) { seeds[w.word] |= w.bits; });
            }
        }
    }
    replaceSeeds(std::move(seeds));
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
    for (std::uint32_t row = 0; row < rows.window().size(); ++row)
    {
        const VoxelRun run = rows.run(row);
        if (run.first > run.last)
        {
            continue;
        }
        layout_.forEachWord(run.y, run.z, run.first, run.last,
                            [&](VoxelWord w)
                            {
                                const std::uint64_t bits = open_[w.word] & w.bits;
                                if (bits != 0)
                                {
                                    open_[w.word] &= ~bits;
                                    blocked_.push_back({w.word, bits});
                                }
                            });
    }
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
    const BallRows rows(layout_.frame, p, distance + kRounding, kMeetsBall);
    for (std::uint32_t row = 0; row < rows.window().size(); ++row)
    {
        const VoxelRun run = rows.run(row);
        if (run.first <= run.last && layout_.any(open_, run.y, run.z, run.first, run.last))
        {
            return true;
        }
    }
    return false;
}

bool ReachMap::sphereDroppable(const Eigen::Vector3d& centre, double radius, Cursor& cursor) const
{
    if (!active_)
    {
        return false;
    }
    const double distance = radius + radii_.largest + margins_.query + kRounding;
    const BallRows rows(layout_.frame, centre, distance, kMeetsBall);
    for (; cursor < rows.window().size(); ++cursor)
    {
        const VoxelRun run = rows.run(cursor);
        if (run.first <= run.last && layout_.any(open_, run.y, run.z, run.first, run.last))
        {
            return false;
        }
    }
    return true;
}

bool ReachMap::polygonDroppable(std::uint32_t triangle)
{
    if (!active_)
    {
        return false;
    }
    const double distance =
        radii_.largest + margins_.query + kHalfDiagonal * layout_.frame.cell + kRounding;
    const TriangleRows rows(layout_.frame, surface_[triangle], distance);
    for (Cursor& cursor = triangleCursor_[triangle]; cursor < rows.window().size(); ++cursor)
    {
        const VoxelRun run = rows.run(cursor);
        if (run.last < run.first || !layout_.any(open_, run.y, run.z, run.first, run.last))
        {
            continue;
        }
        for (int x = run.first; x <= run.last; ++x)
        {
            const VoxelWord cube = layout_.at(x, run.y, run.z);
            if ((open_[cube.word] & cube.bits) != 0 && rows.near(x, run.y, run.z))
            {
                return false;
            }
        }
    }
    return true;
}

} // namespace frostfill
