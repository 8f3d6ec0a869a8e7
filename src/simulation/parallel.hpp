// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace frostfill
{

/// Threads for the loops of a simulation. A loop's body may write only what belongs to its own
/// index, so that results do not depend on the number of threads.
class Threads
{
public:
    /// 0 takes as many as there are cores.
    explicit Threads(int count)
        : limit_(tbb::global_control::max_allowed_parallelism,
                 static_cast<std::size_t>(count > 0 ? count : tbb::info::default_concurrency())),
          arena_(count > 0 ? count : tbb::task_arena::automatic)
    {
    }

    [[nodiscard]] int concurrency() const { return arena_.max_concurrency(); }

    /// Calls body(i) for each i below `count`; on this thread when that is not worth sharing.
    template <class Body>
    void forEach(std::size_t count, Body&& body)
    {
        if (count < kWorthSharing)
        {
            alone(count, body);
            return;
        }
        share(count, kGrain, tbb::static_partitioner(), body);
    }

    /// The same for few bodies that take long.
    template <class Body>
    void forEachLarge(std::size_t count, Body&& body)
    {
        share(count, 1, tbb::simple_partitioner(), body);
    }

private:
    template <class Body>
    static void alone(std::size_t count, Body& body)
    {
        for (std::size_t i = 0; i < count; ++i)
        {
            body(i);
        }
    }

    template <class Partitioner, class Body>
    void share(std::size_t count, std::size_t grain, const Partitioner& partitioner, Body& body)
    {
        if (concurrency() == 1)
        {
            alone(count, body);
            return;
        }
        arena_.execute(
            [&]
            {
                tbb::parallel_for(
                    tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range)
                    {
                        for (std::size_t i = range.begin(); i != range.end(); ++i)
                        {
                            body(i);
                        }
                    },
                    partitioner);
            });
    }

    static constexpr std::size_t kWorthSharing = 64;
    static constexpr std::size_t kGrain = 16;
    tbb::global_control limit_; ///< lets more threads than cores work, when asked for
    tbb::task_arena arena_;
};

} // namespace frostfill
