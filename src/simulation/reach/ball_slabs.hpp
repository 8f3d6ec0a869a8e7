// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "geometry/grid_frame.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// Balls sorted by slabs of a grid's layers along z, so thick that what lies within `reach` of a
/// ball's centre is in its own slab or one beside it: see forEachSlab. Every number of threads sees
/// the same order.
class BallSlabs
{
public:
    BallSlabs(const GridFrame& frame, std::span<const Ball> balls, double reach);

    [[nodiscard]] int count() const { return static_cast<int>(first_.size()) - 1; }
    [[nodiscard]] std::span<const Ball> slab(int slab) const
    {
        const auto its = static_cast<std::size_t>(slab);
        return std::span(balls_).subspan(first_[its], first_[its + 1] - first_[its]);
    }

    /// Calls body(ball, slab) for each ball; see forEachSlab for what it may write.
    template <class Body>
    void forEach(Threads& threads, Body&& body) const
    {
        forEachSlab(threads, count(),
                    [&](int its)
                    {
                        for (const Ball& ball : slab(its))
                        {
                            body(ball, static_cast<std::size_t>(its));
                        }
                    });
    }

private:
    std::vector<Ball> balls_;        ///< slab by slab, in each as given
    std::vector<std::size_t> first_; ///< [#slabs + 1] of each slab, and their number
};

} // namespace frostfill
