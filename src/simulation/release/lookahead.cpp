// SPDX-License-Identifier: MIT
#include "simulation/release/lookahead.hpp"

#include <algorithm>

namespace frostfill
{

Draw& Lookahead::expect(const Draw::Key& key)
{
    draws_.resize(kMostAhead);
    Draw& draw = draws_[key.number % kMostAhead];
    if (draw.key != key)
    {
        draw.key = key;
        draw.forget();
    }
    last_ = std::max(last_, key.number);
    return draw;
}

void Lookahead::voidNear(const Eigen::Vector3d& centre, double radius, std::uint64_t number)
{
    while (++number <= last_)
    {
        Draw& draw = draws_[number % kMostAhead];
        if (draw.isLookedAt && draw.seen.meets(centre, radius))
        {
            draw.forget();
        }
    }
}

} // namespace frostfill
