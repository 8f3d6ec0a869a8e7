// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/reach/ball_slabs.hpp"
#include "simulation/reach/clear_search.hpp"
#include "simulation/reach/sparse_voxel_bits.hpp"
#include "simulation/reach/voxel_layout.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace frostfill
{

/// What is known of cubes that may hold a place for a sphere. Many obstacles ask for the same cube,
/// which is searched only once until something comes to rest beside it. Several threads may ask at
/// once: every search of a cube finds the same.
class HeldCubes
{
public:
    /// Both outlive this.
    HeldCubes(const VoxelLayout& layout, const ClearSearch& search)
        : layout_(layout), search_(search), held_(layout.words, 0), empty_(layout.words)
    {
    }

    /// Whether a cube may hold a place.
    [[nodiscard]] bool mayHold(int x, int y, int z);
    /// Whether it is known to, without a search.
    [[nodiscard]] bool isHeld(CubeNumber cube) const
    {
        const VoxelWord its = cubeOf(cube);
        return (load(held_[its.word]) & its.bits) != 0;
    }
    /// Calls visit(VoxelWord), ascending, for the cubes that were found since to hold none.
    template <class Visit>
    void drainEmpty(Visit&& visit)
    {
        if (emptyWords_.empty())
        {
            return;
        }
        sortEmpty();
        for (const std::size_t word : emptyWords_)
        {
            visit(VoxelWord{word, empty_[word]});
        }
        empty_.clear();
        emptyWords_.clear();
    }

    /// Spheres have come to rest: whether they leave places in the cubes within `distance` of their
    /// surface has to be found out anew.
    void forgetNear(const BallSlabs& balls, double distance, Threads& threads);
    /// The search finds more than before.
    void forgetAll();

private:
    void sortEmpty();
    [[nodiscard]] static std::uint64_t load(const std::uint64_t& word)
    {
        return std::atomic_ref(const_cast<std::uint64_t&>(word)).load(std::memory_order_relaxed);
    }

    const VoxelLayout& layout_;
    const ClearSearch& search_;
    VoxelBits held_;        ///< cubes that may hold a place: nothing has come to rest there since
    SparseVoxelBits empty_; ///< cubes that hold none, since the last drain
    std::mutex lock_;       ///< of the words
    std::vector<std::size_t> emptyWords_;
};

} // namespace frostfill
