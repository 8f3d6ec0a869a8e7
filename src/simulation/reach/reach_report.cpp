// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_report.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

// Cubes up to `reach` to the left and right of a word's, those of the words beside it included.
// They are of the same row: reached cubes keep more than a radius from both ends of theirs.
std::uint64_t widened(const VoxelLayout& layout, const VoxelBits& set, std::size_t word, int reach)
{
    const WordsBeside beside = layout.beside(word);
    const std::uint64_t left = set[beside.left];
    const std::uint64_t here = set[word];
    const std::uint64_t right = set[beside.right];
    std::uint64_t result = here;
    for (int shift = 1; shift <= reach; ++shift)
    {
        result |= here << shift | here >> shift | left >> (64 - shift) | right << (64 - shift);
    }
    return result;
}

/// Cubes whose middle comes within `radius` of a cube of the set, radius in cubes.
class Dilation
{
public:
    Dilation(const VoxelLayout& layout, const VoxelBits& set, double radius)
        : layout_(layout), set_(set), radius_(radius), reach_(static_cast<int>(std::lround(radius)))
    {
    }

    [[nodiscard]] std::uint64_t word(std::size_t word) const
    {
        const auto [x, y, z] = layout_.coordinates(word);
        std::uint64_t result = 0;
        for (int dy = -reach_; dy <= reach_; ++dy)
        {
            for (int dz = -reach_; dz <= reach_; ++dz)
            {
                const auto& count = layout_.frame.count;
                const double rest = radius_ * radius_ - square(dy) - square(dz);
                if (rest < 0 || y + dy < 0 || y + dy >= count[1] || z + dz < 0 ||
                    z + dz >= count[2])
                {
                    continue;
                }
                result |= widened(layout_, set_, layout_.word(x / 64, y + dy, z + dz),
                                  std::min(63, static_cast<int>(std::lround(std::sqrt(rest)))));
            }
        }
        return result;
    }

private:
    // Distance from the middle of a cube to the cube so many farther on.
    static double square(int cubes)
    {
        const double distance = std::max(0.0, std::abs(cubes) - 0.5);
        return distance * distance;
    }

    const VoxelLayout& layout_;
    const VoxelBits& set_;
    double radius_;
    int reach_;
};

bool isInside(const VoxelLayout& layout, const InsideTest& inside, VoxelWord cube)
{
    bool result = false;
    layout.forEachCube(cube, [&](int x, int y, int z)
                       { result = inside.contains(layout.frame.centre(x, y, z)); });
    return result;
}

// Cubes inside that no sphere covers. Only of the few that are blocked and that no sphere covers,
// wherever they are, each is asked for its side.
VoxelBits uncoveredCubes(const ReachMap& map, const ReachMap::Unblocked& unblocked,
                         const InsideTest& inside, Threads& threads)
{
    const VoxelLayout& layout = map.layout();
    const Dilation covered(layout, map.reached(), map.radii().smallest / layout.frame.cell);
    VoxelBits result(layout.words, 0);
    const auto look = [&](std::size_t word)
    {
        const std::uint64_t blocked = layout.inGrid(word) & ~unblocked.all[word];
        const std::uint64_t maybe = (blocked | unblocked.inside[word]) & ~map.reached()[word];
        if (maybe == 0)
        {
            return;
        }
        const std::uint64_t here = maybe & ~covered.word(word);
        result[word] = here & unblocked.inside[word];
        for (std::uint64_t left = here & blocked; left != 0; left &= left - 1)
        {
            const VoxelWord cube{word, left & -left};
            result[word] |= isInside(layout, inside, cube) ? cube.bits : 0;
        }
    };
    threads.forEach(layout.words, look);
    return result;
}

std::vector<UnreachablePart> findParts(const VoxelLayout& layout, VoxelBits cubes,
                                       double smallestPart)
{
    std::vector<UnreachablePart> parts;
    VoxelFlood flood(layout);
    const double edge = layout.frame.cell;
    for (std::size_t word = 0; word < cubes.size(); ++word)
    {
        while (cubes[word] != 0)
        {
            flood.run(cubes, {word, cubes[word] & -cubes[word]}, [](VoxelWord) { return false; });
            std::size_t count = 0;
            UnreachablePart part;
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            flood.drain(
                [&](VoxelWord w)
                {
                    cubes[w.word] &= ~w.bits;
                    layout.forEachCube(w,
                                       [&](int x, int y, int z)
                                       {
                                           const auto p = layout.frame.centre(x, y, z);
                                           ++count;
                                           sum += p;
                                           part.box.extend(Eigen::Vector3d(p.array() - edge / 2));
                                           part.box.extend(Eigen::Vector3d(p.array() + edge / 2));
                                       });
                });
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

ReachReport reportReach(const ReachMap& map, const ReachMap::Unblocked& unblocked,
                        const InsideTest& inside, double smallestPart, Threads& threads)
{
    ReachReport report;
    if (!map.active())
    {
        return report;
    }
    VoxelBits uncovered = uncoveredCubes(map, unblocked, inside, threads);
    std::size_t missed = 0;
    for (const std::uint64_t word : uncovered)
    {
        missed += static_cast<std::size_t>(std::popcount(word));
    }
    const double edge = map.layout().frame.cell;
    report.resolution = edge;
    report.unreachedVolume = static_cast<double>(missed) * (edge * edge * edge);
    report.parts = findParts(map.layout(), std::move(uncovered), smallestPart);
    return report;
}

} // namespace frostfill
