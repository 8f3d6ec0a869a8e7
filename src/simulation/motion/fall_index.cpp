// SPDX-License-Identifier: MIT
#include "simulation/motion/fall_index.hpp"

#include <algorithm>
#include <utility>

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

FallIndex::FallIndex(const SphereGrid& spheres, const TriangleGrid& triangles)
    : FallIndex(spheres.frame(), triangles)
{
    for (std::size_t level = 1; level < spheres.levels(); ++level)
    {
        const GridFrame& frame = spheres.frame(level);
        BrickedCells<1> words({(frame.count[1] + 63) / 64, frame.count[0], frame.count[2]});
        const std::size_t size = words.size();
        finer_.push_back({frame, std::move(words), std::vector<std::uint64_t>(size)});
    }
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

void FallIndex::insert(const Eigen::Vector3d& centre, std::size_t level)
{
    if (level > 0)
    {
        Level& one = finer_[level - 1];
        const auto c = one.frame.coordinates(centre);
        const std::size_t word = one.words.obtain(c[1] / 64, c[0], c[2]);
        if (word >= one.spheres.size())
        {
            one.spheres.resize(one.words.size());
        }
        one.spheres[word] |= std::uint64_t{1} << (c[1] % 64);
        return;
    }
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

int FallIndex::highestSphere(int x, int z, int y, std::size_t level, int beside) const
{
    if (level == 0)
    {
        return highestSphere(x, z, y);
    }
    const Level& one = finer_[level - 1];
    int highest = -1;
    for (int nz = std::max(0, z - beside); nz <= std::min(one.frame.count[2] - 1, z + beside); ++nz)
    {
        for (int nx = std::max(0, x - beside); nx <= std::min(one.frame.count[0] - 1, x + beside);
             ++nx)
        {
            const auto wordAt = [&](int index)
            {
                const std::size_t word = one.words.find(index, nx, nz);
                return word == BrickedCells<1>::kNone ? 0 : one.spheres[word];
            };
            // No lower than what is found already.
            const int most = std::max(highest, 0) / 64;
            highest = std::max(highest, highestIn(y, wordAt, most));
        }
    }
    return highest;
}

} // namespace frostfill
