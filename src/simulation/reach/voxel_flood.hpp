// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/reach/voxel_layout.hpp"

#include <vector>

namespace frostfill
{

/// The cubes of a row's word that are connected with `start` inside `open`: the occluded fill of
/// chess programs, six doublings to each side [Kogge & Stone 1973].
[[nodiscard]] inline std::uint64_t fillWord(std::uint64_t start, std::uint64_t open)
{
    std::uint64_t up = start & open;
    std::uint64_t down = up;
    std::uint64_t upOpen = open;
    std::uint64_t downOpen = open;
    for (int shift = 1; shift < 64; shift *= 2)
    {
        up |= upOpen & (up << shift);
        upOpen &= upOpen << shift;
        down |= downOpen & (down >> shift);
        downOpen &= downOpen >> shift;
    }
    return up | down;
}

/// Calls visit(VoxelWord) for the cubes that share a face with `cubes`, the upper ones last.
template <class Visit>
void forEachNeighbour(const VoxelLayout& layout, VoxelWord cubes, Visit&& visit)
{
    const std::uint64_t bits = cubes.bits;
    const WordsBeside beside = layout.beside(cubes.word);
    visit(VoxelWord{beside.below, bits});
    visit(VoxelWord{beside.before, bits});
    visit(VoxelWord{beside.behind, bits});
    if ((bits & 1) != 0)
    {
        visit(VoxelWord{beside.left, std::uint64_t{1} << 63});
    }
    if ((bits >> 63) != 0)
    {
        visit(VoxelWord{beside.right, 1});
    }
    visit(VoxelWord{beside.above, bits});
}

/// Flood through face-connected cubes, a word at a time. The newest cubes go first and those above
/// last onto the stack, so that a flood climbs before it spreads: the way out of a pile is up.
class VoxelFlood
{
public:
    VoxelFlood() = default;
    explicit VoxelFlood(const VoxelLayout& layout) : layout_(layout) {}

    /// Visits what is connected with `start` inside `open`, until stop(VoxelWord) says that some
    /// cubes are enough. Returns whether it did. To be followed by drain.
    template <class Stop>
    bool run(const VoxelBits& open, VoxelWord start, Stop&& stop)
    {
        visited_.resize(layout_.words, 0);
        push(open, start);
        while (!stack_.empty())
        {
            const std::size_t word = stack_.back();
            stack_.pop_back();
            const VoxelWord here{word, fillWord(visited_[word], open[word])};
            visited_[word] = here.bits;
            // Asked for neighbours as well, lest a flood climb all the way beside an earlier one.
            bool enough = stop(here);
            forEachNeighbour(layout_, here,
                             [&](VoxelWord next)
                             {
                                 const std::uint64_t fresh = push(open, next);
                                 enough = enough || (fresh != 0 && stop({next.word, fresh}));
                             });
            if (enough)
            {
                stack_.clear();
                return true;
            }
        }
        return false;
    }

    /// Hands over what was visited since the last drain and forgets it.
    template <class Visit>
    void drain(Visit&& visit)
    {
        for (const std::size_t word : touched_)
        {
            visit(VoxelWord{word, visited_[word]});
            visited_[word] = 0;
        }
        touched_.clear();
    }

    /// To be called after a flood of everything that is drained: there may never be another.
    void releaseMemory() { *this = VoxelFlood(layout_); }

private:
    // Returns the cubes that had not been visited.
    std::uint64_t push(const VoxelBits& open, VoxelWord cubes)
    {
        const std::uint64_t seen = visited_[cubes.word];
        const std::uint64_t fresh = cubes.bits & open[cubes.word] & ~seen;
        if (fresh != 0)
        {
            if (seen == 0)
            {
                touched_.push_back(cubes.word);
            }
            visited_[cubes.word] = seen | fresh;
            stack_.push_back(cubes.word);
        }
        return fresh;
    }

    VoxelLayout layout_;
    VoxelBits visited_;
    std::vector<std::size_t> stack_;
    std::vector<std::size_t> touched_; ///< words with visited cubes
};

} // namespace frostfill
