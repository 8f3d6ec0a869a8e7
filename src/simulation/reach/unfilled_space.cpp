// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_inspection.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

// Cubes up to `reach` to the left and right of a word's, those of the words beside it included.
std::uint64_t widened(const Cubes& cubes, const CubeSet& set, const GridPlace& at, int reach)
{
    const auto [x, y, z] = at;
    const std::uint64_t here = set[cubes.wordIfAny(x, y, z)];
    const std::uint64_t left = set[cubes.wordIfAny(x - 1, y, z)];
    const std::uint64_t right = set[cubes.wordIfAny(x + 1, y, z)];
    std::uint64_t result = here;
    for (int shift = 1; shift <= reach; ++shift)
    {
        result |= here << shift | here >> shift | left >> (64 - shift) | right << (64 - shift);
    }
    return result;
}

// Of a word, the cubes whose middle comes within `radius` of a cube of the set, radius in cubes.
std::uint64_t dilated(const Cubes& cubes, const CubeSet& set, std::size_t word, double radius)
{
    const auto square = [](int steps) // of the distance from a middle to the cube so many farther
    {
        const double distance = std::max(0.0, std::abs(steps) - 0.5);
        return distance * distance;
    };
    const auto [x, y, z] = cubes.first(word);
    const int reach = static_cast<int>(std::lround(radius));
    std::uint64_t result = 0;
    for (int dy = -reach; dy <= reach; ++dy)
    {
        for (int dz = -reach; dz <= reach; ++dz)
        {
            const double rest = radius * radius - square(dy) - square(dz);
            if (rest >= 0)
            {
                result |= widened(cubes, set, {x / 64, y + dy, z + dz},
                                  std::min(63, static_cast<int>(std::lround(std::sqrt(rest)))));
            }
        }
    }
    return result;
}

std::vector<UnreachableVolume> findParts(const Cubes& cubes, CubeSet left, double smallestPart)
{
    std::vector<UnreachableVolume> parts;
    const double edge = cubes.frame().cell;
    for (std::size_t word = 0; word < left.size(); ++word)
    {
        while (left[word] != 0)
        {
            std::size_t count = 0;
            UnreachableVolume part;
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            const auto take = [&](const GridPlace& cube)
            {
                const Eigen::Vector3d p = cubes.middle(cube);
                ++count;
                sum += p;
                part.box.extend(Eigen::Vector3d(p.array() - edge / 2));
                part.box.extend(Eigen::Vector3d(p.array() + edge / 2));
            };
            cubes.takeConnected(left, {word, left[word] & -left[word]},
                                [&](CubeWord found) { cubes.forEachCube(found, take); });
            part.volume = static_cast<double>(count) * edge * edge * edge;
            part.centre = sum / static_cast<double>(count);
            if (part.volume >= smallestPart)
            {
                parts.push_back(part);
            }
        }
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.volume > b.volume; });
    return parts;
}

} // namespace

// Only of the few cubes that are blocked and that no sphere covers, wherever they are, each is
// asked for its side.
UnfilledSpace unfilledSpace(const OpenCubes& open, const CubeSet& unblocked,
                            const CubeSet& unblockedInside, const InsideTest& inside,
                            double smallestPart, Threads& threads)
{
    const Cubes& cubes = open.cubes;
    const double edge = cubes.frame().cell;
    CubeSet unfilled(cubes.words(), 0);
    const auto look = [&](std::size_t word)
    {
        const std::uint64_t blocked = cubes.inGrid(word) & ~unblocked[word];
        const std::uint64_t maybe = (blocked | unblockedInside[word]) & ~open.inside[word];
        const std::uint64_t here =
            maybe == 0 ? 0 : maybe & ~dilated(cubes, open.inside, word, open.probe / edge);
        unfilled[word] = here & unblockedInside[word];
        for (std::uint64_t left = here & blocked; left != 0; left &= left - 1)
        {
            const CubeWord cube{word, left & -left};
            cubes.forEachCube(
                cube, [&](const GridPlace& place)
                { unfilled[word] |= inside.contains(cubes.middle(place)) ? cube.bits : 0; });
        }
    };
    threads.forEach(cubes.words(), look);
    std::size_t count = 0;
    for (const std::uint64_t word : unfilled)
    {
        count += static_cast<std::size_t>(std::popcount(word));
    }
    return {static_cast<double>(count) * edge * edge * edge,
            findParts(cubes, std::move(unfilled), smallestPart)};
}

} // namespace frostfill
