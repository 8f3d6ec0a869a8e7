// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include "base/cores.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace frostfill
{

struct Threads::Arena
{
    tbb::task_arena threads;
};

Threads::Threads(int count)
    : concurrency_(static_cast<std::size_t>(count > 0 ? count : coresAtHand())),
      arena_(std::make_unique<Arena>(Arena{tbb::task_arena(static_cast<int>(concurrency_))}))
{
}

Threads::~Threads() = default;

void Threads::share(std::size_t count, Run run, const void* body)
{
    arena_->threads.execute(
        [&]
        {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                              [&](const tbb::blocked_range<std::size_t>& part)
                              { run(body, part.begin(), part.end()); });
        });
}

} // namespace frostfill
