// SPDX-License-Identifier: MIT
#include "simulation/reach/voxel_layout.hpp"

namespace frostfill
{

std::uint64_t VoxelLayout::inGrid(std::size_t word) const
{
    if (isNowhere(word))
    {
        return 0;
    }
    const auto [x, y, z] = coordinates(word);
    const int last = frame.count[0] - 1 - x;
    const bool isRow = y >= 0 && y < frame.count[1] && z < frame.count[2];
    return isRow && last >= 0 ? ~std::uint64_t{0} >> (63 - std::min(63, last)) : 0;
}

std::uint64_t VoxelLayout::besideNothing(std::size_t word) const
{
    const std::uint64_t cubes = inGrid(word);
    if (cubes == 0)
    {
        return 0;
    }
    const WordsBeside around = beside(word);
    if (inGrid(around.below) == 0 || inGrid(around.above) == 0 || inGrid(around.before) == 0 ||
        inGrid(around.behind) == 0)
    {
        return cubes;
    }
    const std::uint64_t first = inGrid(around.left) == 0 ? 1 : 0;
    const std::uint64_t last = inGrid(around.right) == 0 ? cubes & ~(cubes >> 1) : 0;
    return first | last;
}

} // namespace frostfill
