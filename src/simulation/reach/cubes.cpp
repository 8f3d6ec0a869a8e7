// SPDX-License-Identifier: MIT
#include "simulation/reach/cubes.hpp"

#include "simulation/reach/tolerances.hpp"

namespace frostfill
{

std::optional<Cubes> Cubes::inReach(const GridFrame& frame, const InsideTest& inside,
                                    std::size_t most)
{
    Cubes cubes;
    cubes.frame_ = frame;
    cubes.words_ = BrickedCells<1>({frame.count[0] / 64 + 1, frame.count[1], frame.count[2]}, 0);
    const auto add = [&](const Eigen::AlignedBox3d& box)
    {
        if (cubes.words() > most)
        {
            return;
        }
        constexpr int kSide = BrickedCells<1>::kSide;
        const GridPlace low = frame.coordinates(box.min());
        const GridPlace high = frame.coordinates(box.max());
        for (int z = low[2] / kSide; z <= high[2] / kSide; ++z)
        {
            for (int y = low[1] / kSide; y <= high[1] / kSide; ++y)
            {
                for (int x = low[0] / 64; x <= high[0] / 64; ++x)
                {
                    cubes.words_.obtain(x, y * kSide, z * kSide);
                }
            }
        }
    };
    const double all = (frame.count[0] / 64 + 1.0) * frame.count[1] * frame.count[2];
    if (all <= kWholeGrid)
    {
        const auto& [x, y, z] = frame.count;
        add({frame.origin, frame.centre(x - 1, y - 1, z - 1)});
    }
    else
    {
        inside.forEachBoxInReach(add);
    }
    return cubes.words() <= most ? std::optional(std::move(cubes)) : std::nullopt;
}

std::uint64_t Cubes::inGrid(std::size_t word) const
{
    if (word < kNowhere || !words_.isInGrid(words_.cell(word - kNowhere)))
    {
        return 0;
    }
    const int last = frame_.count[0] - 1 - first(word)[0];
    return last < 0 ? 0 : ~std::uint64_t{0} >> (63 - std::min(63, last));
}

std::uint64_t Cubes::outermost(std::size_t word) const
{
    std::uint64_t beside = ~std::uint64_t{0};
    const std::uint64_t cubes = inGrid(word);
    if (cubes != 0)
    {
        const auto [x, y, z] = words_.cell(word - kNowhere);
        for (const int step : {-1, 1})
        {
            beside &= inGrid(wordIfAny(x, y + step, z)) & inGrid(wordIfAny(x, y, z + step));
        }
        beside &= cubes << 1 | inGrid(wordIfAny(x - 1, y, z)) >> 63;
        beside &= cubes >> 1 | inGrid(wordIfAny(x + 1, y, z)) << 63;
    }
    return cubes & ~beside;
}

} // namespace frostfill
