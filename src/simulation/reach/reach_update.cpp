// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_map.hpp"

/// How the reached cubes are found, and kept up to date.
namespace frostfill
{

bool ReachMap::flood(std::span<const Eigen::Vector3d> running)
{
    if (!active_)
    {
        return true;
    }
    takeBlocked();
    unseeded_.clear();
    const bool trusted = anchorRunning(running);
    if (!seeded_)
    {
        keepConnected();
    }
    forgetMarks();
    reachedCount_ = countCubes(open_);
    flooded_ = true;
    return trusted;
}

void ReachMap::keepConnected()
{
    for (const VoxelWord cube : runningCubes_)
    {
        search_.run(open_, cube, [](VoxelWord) { return false; });
    }
    VoxelBits reached(layout_.words, 0);
    search_.drain([&](VoxelWord w) { reached[w.word] = w.bits; });
    for (std::size_t word = 0; word < layout_.words; ++word)
    {
        if ((open_[word] & ~reached[word]) != 0)
        {
            lost_.push_back({word, open_[word] & ~reached[word]});
        }
    }
    open_ = std::move(reached);
}

// As long as spheres may be released in every cube, none is cut off. Later one can only be when a
// neighbour was blocked, its seeds were withdrawn or a running sphere has left. From each such
// suspect a flood looks for a cube with a running sphere or one that is known to be connected with
// one. When it finds one, all it has seen is connected too; when it ends without, all it has seen
// is lost. No cube is visited twice, so one update costs at most one flood.
bool ReachMap::update(std::span<const Eigen::Vector3d> running)
{
    if (!active_)
    {
        return true;
    }
    takeBlocked();
    const std::vector<VoxelWord> left = std::move(runningCubes_);
    const bool trusted = anchorRunning(running);

    if (!seeded_)
    {
        settleBeside(left);
    }
    forgetMarks();

    for (const VoxelWord lost : lost_)
    {
        reachedCount_ -= static_cast<std::size_t>(std::popcount(lost.bits));
    }
    return trusted;
}

// What was blocked, and where seeds or running spheres are gone.
void ReachMap::settleBeside(std::span<const VoxelWord> left)
{
    const std::size_t blockedWords = lost_.size();
    for (std::size_t i = 0; i < blockedWords; ++i)
    {
        const VoxelWord blocked = lost_[i];
        settle({blocked.word, blocked.bits << 1 | blocked.bits >> 1});
        forEachNeighbour(layout_, blocked, [&](VoxelWord next) { settle(next); });
    }
    for (const VoxelWord suspects : unseeded_)
    {
        settle(suspects);
    }
    unseeded_.clear();
    for (const VoxelWord suspects : left)
    {
        settle(suspects);
    }
}

void ReachMap::forgetMarks()
{
    if (!markedWords_.empty())
    {
        marks_.clear();
    }
    markedWords_.clear();
}

void ReachMap::takeBlocked()
{
    lost_.clear();
    for (const std::size_t word : markedWords_)
    {
        lost_.push_back({word, marks_[word]});
    }
    forgetMarks();
}

void ReachMap::mark(VoxelWord cubes, std::vector<std::size_t>& marked)
{
    if (marks_.add(cubes) == 0)
    {
        marked.push_back(cubes.word);
    }
}

bool ReachMap::anchorRunning(std::span<const Eigen::Vector3d> running)
{
    bool trusted = true;
    runningCubes_.clear();
    for (const Eigen::Vector3d& centre : running)
    {
        const VoxelWord cube = layout_.at(centre);
        if ((open_[cube.word] & cube.bits) == 0)
        {
            trusted = false;
            continue;
        }
        runningCubes_.push_back(cube);
        mark(cube, markedWords_);
    }
    return trusted;
}

void ReachMap::settle(VoxelWord suspects)
{
    const std::size_t word = suspects.word;
    while (true)
    {
        const std::uint64_t unsettled = suspects.bits & open_[word] & ~marks_[word];
        if (unsettled == 0)
        {
            return;
        }
        const bool connected =
            search_.run(open_, {word, unsettled & -unsettled},
                        [&](VoxelWord w) { return (w.bits & marks_[w.word]) != 0; });
        search_.drain(
            [&](VoxelWord w)
            {
                if (connected)
                {
                    mark(w, markedWords_);
                }
                else
                {
                    open_[w.word] &= ~w.bits;
                    lost_.push_back(w);
                }
            });
    }
}

} // namespace frostfill
