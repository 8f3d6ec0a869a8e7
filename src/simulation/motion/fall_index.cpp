// SPDX-License-Identifier: MIT
#include "simulation/motion/fall_index.hpp"

#include <algorithm>

namespace frostfill
{

FallIndex::FallIndex(const GridFrame& frame, const TriangleGrid& triangles)
    : frame_(frame), words_({(frame.count[1] + 63) / 64, frame.count[0], frame.count[2]}),
      spheres_(words_.size()), walls_(words_.size())
{
    // A cell is a wall when one of the finer cells of the triangles' grid within it has triangles.
    triangles.forEachCellWithTriangles(
        [&](int x, int y, int z)
        {
            const auto c = frame_.coordinates(triangles.frame().centre(x, y, z));
            walls_[wordOf(c)] |= std::uint64_t{1} << (c[1] % 64);
        });
}

std::size_t FallIndex::wordOf(const GridPlace& cell)
{
    const std::size_t word = words_.obtain(cell[1] / 64, cell[0], cell[2]);
    if (word >= spheres_.size())
    {
        spheres_.resize(words_.size());
        walls_.resize(words_.size());
    }
    return word;
}

void FallIndex::insert(const Eigen::Vector3d& centre)
{
    const auto c = frame_.coordinates(centre);
    spheres_[wordOf(c)] |= std::uint64_t{1} << (c[1] % 64);
}

int FallIndex::highestInBricks(int x, int z, int y, const std::vector<std::uint64_t>& bits) const
{
    return highestIn(y,
                     [&](int index)
                     {
                         const std::size_t word = words_.find(index, x, z);
                         return word == BrickedCells<1>::kNone ? 0 : bits[word];
                     });
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
