// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace frostfill
{

/// Work of a few nanoseconds a sphere: so many are a task.
inline constexpr std::size_t kSpheresPerTask = 4096;

/// Calls visit(i) for all below `count`; cores share the work. One takes `aTask` before another may
/// take more. More: cores wait for each other at the end. Fewer: handing them out costs more.
template <typename Visit>
void forAll(std::size_t count, std::size_t aTask, Visit visit)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, aTask),
                      [&](const auto& range)
                      {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                          {
                              visit(i);
                          }
                      });
}

} // namespace frostfill
