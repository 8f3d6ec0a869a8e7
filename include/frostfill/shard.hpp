// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The part of some work that one of several processes does. All parts together are the whole work,
/// each of it once, in whatever order the parts are done.
struct Shard
{
    std::size_t index = 0; ///< from 0
    std::size_t count = 1; ///< of parts

    /// Whether the k-th of many tasks belongs to this part: every count-th does, so that tasks
    /// that grow from first to last are shared evenly.
    [[nodiscard]] bool owns(std::size_t k) const { return k % count == index; }
    /// The tasks from `first` up to, but not including, `second` of `all`, for tasks that go better
    /// one after the other.
    [[nodiscard]] std::pair<std::size_t, std::size_t> range(std::size_t all) const
    {
        // In two steps: all * (index + 1) may be larger than any number.
        const auto begin = [&](std::size_t i) { return all / count * i + all % count * i / count; };
        return {begin(index), begin(index + 1)};
    }
    friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "3/16", the third of sixteen parts; or "slurm", the part of this task of a job array, from
/// SLURM_ARRAY_TASK_ID, _MIN, _MAX, _STEP and _COUNT. Throws Error usage for anything else, and
/// where there is no such array.
[[nodiscard]] Shard parseShard(std::string_view text);

} // namespace frostfill
#pragma GCC visibility pop
