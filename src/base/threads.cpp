// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include "base/resources.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace frostfill
{

struct Threads::Arena
{
    tbb::task_arena threads;
};

Threads::Threads(int count)
    : concurrency_(static_cast<std::size_t>(count > 0 ? count : coresAtHand()))
{
}

Threads::~Threads() = default;

void Threads::share(std::size_t count, Run run, const void* body)
{
    if (!arena_)
    {
        // oneTBB prints a warning about an arena of more threads than it may start.
        using tbb::global_control;
        const std::size_t most =
            global_control::active_value(global_control::max_allowed_parallelism);
        const std::size_t wanted = std::min(concurrency_, most);
        arena_ = std::make_unique<Arena>(Arena{tbb::task_arena(static_cast<int>(wanted))});
    }
    arena_->threads.execute(
        [&]
        {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                              [&](const tbb::blocked_range<std::size_t>& part)
                              { run(body, part.begin(), part.end()); });
        });
}

} // namespace frostfill
