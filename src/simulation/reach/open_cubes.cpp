// SPDX-License-Identifier: MIT
#include "simulation/reach/open_cubes.hpp"

#include "mesh/interior/near_surface.hpp"
#include "mesh/interior/winding_columns.hpp"

#include <limits>
#include <unordered_set>
#include <utility>

namespace frostfill
{
namespace
{

// Takes the smallest edge from `voxel` on with which a set of cubes fits into memory. Returns
// nothing when that edge is longer than `largest`.
std::optional<Cubes> chooseCubes(const Surface& surface, const InsideTest& inside, double margin,
                                 double voxel, double largest, std::size_t bytes)
{
    for (; voxel <= largest;
         voxel = std::min(voxel * kGrowth, std::max(largest, voxel * kMinGrowth)))
    {
        // In floating point, for the numbers of cubes may not fit an int.
        const double longest = surface.box().sizes().maxCoeff() + 2 * margin;
        if (longest / voxel + 68 > std::numeric_limits<int>::max())
        {
            continue;
        }
        const GridFrame frame = GridFrame::cover(surface.box(), voxel, margin + 2 * voxel);
        const auto most = static_cast<double>(bytes / sizeof(std::uint64_t));
        if (auto cubes = Cubes::inReach(frame, inside, most, kWholeGrid))
        {
            return cubes;
        }
    }
    return std::nullopt;
}

// Breadth first: the cubes from `start` to the nearest one at the border.
std::vector<GridPlace> shortestExit(const Cubes& cubes, CubeSet unseen, const GridPlace& start)
{
    struct Step
    {
        GridPlace cube;
        std::size_t from;
    };
    std::vector<Step> queue = {{start, 0}};
    unseen[cubes.at(start).word] &= ~cubes.at(start).bits;
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
        const GridPlace here = queue[head].cube;
        const CubeWord its = cubes.at(here);
        if ((cubes.outermost(its.word) & its.bits) != 0)
        {
            std::vector<GridPlace> way = {here};
            for (std::size_t k = head; k != 0; k = queue[k].from)
            {
                way.push_back(queue[queue[k].from].cube);
            }
            return {way.rbegin(), way.rend()};
        }
        const auto take = [&](CubeWord next)
        {
            next.bits &= unseen[next.word];
            unseen[next.word] &= ~next.bits;
            if (next.bits != 0)
            {
                cubes.forEachCube(next,
                                  [&](const GridPlace& cube) {
                                      queue.push_back({cube, head});
                                  });
            }
        };
        take({its.word, its.bits << 1 | its.bits >> 1});
        cubes.forEachNeighbour(its, take);
    }
    return {};
}

// A way from inside to the border for a sphere of the given radius: a point in a hole, the first on
// the shortest way out. `outer` are the cubes that its centre can get to from the border.
std::optional<Eigen::Vector3d> findLeak(const Surface& surface, const InsideTest& inside,
                                        const Cubes& cubes, const CubeSet& outer, double radius)
{
    std::unordered_set<std::uint64_t> looked; // many small triangles lead to one cube
    for (std::uint32_t id = 0; id < surface.size(); ++id)
    {
        // Where the centre of a sphere would be that touches the triangle from inside.
        const auto& [a, b, c] = surface[id].corner;
        const GridPlace start =
            cubes.frame().coordinates((a + b + c) / 3 + radius * surface.bound(id).normal);
        const CubeWord cube = cubes.at(start);
        const std::uint64_t number = 64 * cube.word + std::countr_zero(cube.bits);
        if (!has(outer, cube) || !looked.insert(number).second ||
            !inside.contains(cubes.middle(start)))
        {
            continue;
        }
        // On the way out the winding number falls from one to nothing; a hole is where it is half.
        for (const GridPlace& step : shortestExit(cubes, outer, start))
        {
            if (windingNumber(surface.mesh(), cubes.middle(step)) < kInsideFrom)
            {
                return cubes.middle(step);
            }
        }
    }
    return std::nullopt;
}

} // namespace

EmptyObject openCubesOf(const Surface& surface, const InsideTest& inside, double probe,
                        std::size_t bytes, Threads& threads, CubeSet* unblocked)
{
    OpenCubes open;
    open.probe = probe;
    const double largest = kLargestVoxel * open.exclusion(probe);
    auto cubes =
        chooseCubes(surface, inside, probe, std::min(kReachVoxel * probe, largest), largest, bytes);
    if (!cubes)
    {
        return {};
    }
    open.cubes = *std::move(cubes);
    const Cubes& all = open.cubes;
    CubeSet left = cubesFartherThan(
        surface, all, open.exclusion(probe) - kHalfDiagonal * all.frame().cell, all.all(), threads);
    if (unblocked != nullptr)
    {
        *unblocked = left;
    }
    // Cubes at the border are outside, unless the surface has a hole.
    CubeSet outer(all.words(), 0);
    for (std::size_t word = 0; word < left.size(); ++word)
    {
        if (left[word] != 0)
        {
            all.takeConnected(left, {word, all.outermost(word)},
                              [&](CubeWord found) { outer[found.word] |= found.bits; });
        }
    }
    EmptyObject result;
    result.leak = findLeak(surface, inside, all, outer, probe);
    if (!result.leak)
    {
        outer = {};
        open.inside = cubesInside(all, inside, std::move(left));
        result.open = std::move(open);
    }
    return result;
}

} // namespace frostfill
