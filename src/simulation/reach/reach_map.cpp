// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_map.hpp"

#include "simulation/reach/voxel_rows.hpp"

namespace frostfill
{

void ReachMap::withdrawSeeds()
{
    for (std::size_t word = 0; flooded_ && seeded_ && word < open_.size(); ++word)
    {
        if (open_[word] != 0)
        {
            unseeded_.push_back({word, open_[word]});
        }
    }
    seeded_ = false;
}

void ReachMap::addResting(const BallSlabs& balls, Threads& threads)
{
    std::vector<std::vector<std::size_t>> marked(static_cast<std::size_t>(balls.count()));
    balls.forEach(threads, [&](const Ball& ball, std::size_t slab)
                  { closeBall(ball.position(), ball.radius, marked[slab]); });
    for (const std::vector<std::size_t>& words : marked)
    {
        markedWords_.insert(markedWords_.end(), words.begin(), words.end());
    }
}

void ReachMap::closeBall(const Eigen::Vector3d& centre, double radius,
                         std::vector<std::size_t>& marked)
{
    if (!active_)
    {
        return;
    }
    BallRows(layout_.frame, centre, exclusion(radius + radii_.smallest), kInsideBall)
        .forEachWord(layout_, open_, [&](VoxelWord w) { block(w, marked); });
}

void ReachMap::block(VoxelWord cubes, std::vector<std::size_t>& marked)
{
    const std::uint64_t bits = open_[cubes.word] & cubes.bits;
    if (bits == 0)
    {
        return;
    }
    open_[cubes.word] &= ~bits;
    mark({cubes.word, bits}, marked);
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

bool ReachMap::polygonDroppable(std::uint32_t triangle) const
{
    bool isNear = false;
    const auto any = [](int, int, int) { return true; };
    if (active_)
    {
        findNear({{&triangle, 1}, {}}, {}, any, [&](std::size_t, VoxelWord) { isNear = true; });
    }
    return active_ && !isNear;
}

bool ReachMap::reaches(const Eigen::Vector3d& p, double distance) const
{
    if (!active_)
    {
        return true;
    }
    Cursor fromTheTop = 0;
    return findNearSphere(p, distance + kReachRounding, fromTheTop,
                          [](int, int, int) { return true; });
}

} // namespace frostfill
