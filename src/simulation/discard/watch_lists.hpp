// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/reach/voxel_layout.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace frostfill
{

/// Obstacles by the cube that each of them watches: its witness, a place from which it can be
/// touched. As long as that stands, none of them is looked at: a look costs what the witnesses are,
/// not what the obstacles are. These are the watch lists of SAT solvers [Moskewicz et al. 2001].
class WatchLists
{
public:
    struct Watcher
    {
        std::uint32_t obstacle;
        CubeNumber witness; ///< may be kNoCube
    };

    /// For obstacles 0 to count - 1, none of which watches a cube yet.
    explicit WatchLists(std::size_t count) : next_(count, kNone) {}

    /// Some begin to watch. Those of one cube follow each other. Each watches one cube at most.
    void add(const std::vector<Watcher>& watchers);
    /// Takes out those for whose witness stands(cube) does not hold, ascending by obstacle. Several
    /// threads ask at once.
    template <class Stands>
    [[nodiscard]] std::vector<Watcher> takeFallen(Threads& threads, Stands&& stands)
    {
        stands_.resize(lists_.size());
        threads.forEach(lists_.size(),
                        [&](std::size_t i) { stands_[i] = stands(lists_[i].witness); });
        return takeFallen();
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    struct List
    {
        CubeNumber witness;
        std::uint32_t first;
    };

    std::vector<Watcher> takeFallen();

    std::vector<List> lists_;         ///< a cube may have several
    std::vector<std::uint32_t> next_; ///< by obstacle: the next one of its list
    std::vector<char> stands_;        ///< by list
};

} // namespace frostfill
