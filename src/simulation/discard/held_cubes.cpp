// SPDX-License-Identifier: MIT
#include "simulation/discard/held_cubes.hpp"

#include "simulation/reach/tolerances.hpp"
#include "simulation/reach/voxel_rows.hpp"

#include <algorithm>
#include <atomic>

namespace frostfill
{
namespace
{

/// So that no rounding matters.
constexpr double kOfPart = 1 - 1e-6;

bool has(VoxelBits& set, VoxelWord cube)
{
    return (std::atomic_ref(set[cube.word]).load(std::memory_order_relaxed) & cube.bits) != 0;
}

void add(VoxelBits& set, VoxelWord cube)
{
    std::atomic_ref(set[cube.word]).fetch_or(cube.bits, std::memory_order_relaxed);
}

} // namespace

bool HeldCubes::mayHold(int x, int y, int z)
{
    const VoxelWord cube = layout_.at(x, y, z);
    if (has(held_, cube))
    {
        return true;
    }
    if ((empty_[cube.word] & cube.bits) != 0)
    {
        return false;
    }
    const GridFrame& frame = layout_.frame;
    if (search_.mayBeClear(frame.centre(x, y, z), frame.cell))
    {
        add(held_, cube);
        return true;
    }
    if (empty_.addShared(cube) == 0)
    {
        const std::lock_guard guard(lock_);
        emptyWords_.push_back(cube.word);
    }
    return false;
}

void HeldCubes::sortEmpty()
{
    std::sort(emptyWords_.begin(), emptyWords_.end());
}

void HeldCubes::forgetNear(const BallSlabs& balls, double distance, Threads& threads)
{
    // What lies in a ball as a whole comes nearer to its centre than its surface by its own edge.
    const double reach = distance - kOfPart * search_.edgeOfPart(layout_.frame.cell);
    balls.forEach(
        threads,
        [&](const Ball& ball, std::size_t)
        {
            const BallRows rows(layout_.frame, ball.position(), ball.radius + reach, kMeetsBall);
            rows.forEachWord(layout_, held_, [&](VoxelWord w) { held_[w.word] &= ~w.bits; });
        });
}

void HeldCubes::forgetAll()
{
    std::fill(held_.begin(), held_.end(), 0);
}

} // namespace frostfill
