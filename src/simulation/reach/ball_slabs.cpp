// SPDX-License-Identifier: MIT
#include "simulation/reach/ball_slabs.hpp"

#include <cmath>
#include <numeric>

namespace frostfill
{

BallSlabs::BallSlabs(const GridFrame& frame, std::span<const Ball> balls, double reach)
    : balls_(balls.size())
{
    // Twice what a ball touches on one side, and a layer for rounding.
    const int thickness = 2 * (static_cast<int>(std::ceil(reach / frame.cell)) + 1);
    const auto slabOf = [&](const Ball& ball)
    { return static_cast<std::size_t>(frame.coordinates(ball.position())[2] / thickness); };
    first_.assign(static_cast<std::size_t>((frame.count[2] - 1) / thickness) + 2, 0);
    for (const Ball& ball : balls)
    {
        ++first_[slabOf(ball) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::size_t> next = first_;
    for (const Ball& ball : balls)
    {
        balls_[next[slabOf(ball)]++] = ball;
    }
}

} // namespace frostfill
