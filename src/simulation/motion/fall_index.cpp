// SPDX-License-Identifier: MIT
#include "simulation/motion/fall_index.hpp"

#include <algorithm>
#include <bit>

namespace frostfill
{

FallIndex::FallIndex(const GridFrame& frame, const TriangleGrid& triangles)
    : frame_(frame), words_((static_cast<std::size_t>(frame.count[1]) + 63) / 64),
      spheres_(column(0, frame.count[2])), walls_(spheres_.size())
{
    // A cell is a wall when one of the finer cells of the triangles' grid within it has triangles.
    triangles.forEachCellWithTriangles(
        [&](int x, int y, int z)
        {
            const auto c = frame_.coordinates(triangles.frame().centre(x, y, z));
            walls_[column(c[0], c[2]) + c[1] / 64] |= std::uint64_t{1} << (c[1] % 64);
        });
}

void FallIndex::insert(const Eigen::Vector3d& centre)
{
    const auto c = frame_.coordinates(centre);
    spheres_[column(c[0], c[2]) + c[1] / 64] |= std::uint64_t{1} << (c[1] % 64);
}

int FallIndex::highestBelow(int x, int z, int y, const std::vector<std::uint64_t>& bits) const
{
    const std::uint64_t* word = bits.data() + column(x, z);
    int index = y / 64;
    std::uint64_t candidates = word[index] & (~std::uint64_t{0} >> (63 - y % 64));
    while (candidates == 0 && index > 0)
    {
        candidates = word[--index];
    }
    return candidates == 0 ? -1 : index * 64 + 63 - std::countl_zero(candidates);
}

int FallIndex::highestSphere(int x, int z, int y) const
{
    int highest = -1;
    for (int nz = std::max(0, z - 1); nz <= std::min(frame_.count[2] - 1, z + 1); ++nz)
    {
        for (int nx = std::max(0, x - 1); nx <= std::min(frame_.count[0] - 1, x + 1); ++nx)
        {
            highest = std::max(highest, highestBelow(nx, nz, y, spheres_));
        }
    }
    return highest;
}

} // namespace frostfill
