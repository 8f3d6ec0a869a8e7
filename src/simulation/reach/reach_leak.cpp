// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_leak.hpp"

#include "mesh/interior/winding_number.hpp"

#include <array>
#include <vector>

namespace frostfill
{
namespace
{

using Cube = std::array<int, 3>;

bool isIn(const VoxelLayout& layout, const VoxelBits& set, const Cube& cube)
{
    const VoxelWord w = layout.at(cube[0], cube[1], cube[2]);
    return (set[w.word] & w.bits) != 0;
}

// Breadth first: the cubes from `start` to the nearest one at the border. The way back is kept as
// one direction a cube.
std::vector<Cube> shortestExit(const VoxelLayout& layout, const VoxelBits& open, const Cube& start)
{
    constexpr std::uint8_t kUnseen = 6;
    constexpr std::uint8_t kStart = 7;
    const GridFrame& frame = layout.frame;
    std::vector<std::uint8_t> cameBy(frame.size(), kUnseen);
    const auto indexOf = [&](const Cube& c) { return frame.index(c[0], c[1], c[2]); };
    std::vector<Cube> queue = {start};
    cameBy[indexOf(start)] = kStart;
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
        Cube here = queue[head];
        for (int face = 0; face < 6; ++face)
        {
            const int axis = face / 2;
            Cube next = here;
            next[axis] += face % 2 == 0 ? -1 : 1;
            if (next[axis] < 0 || next[axis] >= frame.count[axis])
            {
                std::vector<Cube> way;
                while (cameBy[indexOf(here)] != kStart)
                {
                    way.push_back(here);
                    const int back = cameBy[indexOf(here)];
                    here[back / 2] += back % 2 == 0 ? 1 : -1;
                }
                way.push_back(start);
                return {way.rbegin(), way.rend()};
            }
            if (isIn(layout, open, next) && cameBy[indexOf(next)] == kUnseen)
            {
                cameBy[indexOf(next)] = static_cast<std::uint8_t>(face);
                queue.push_back(next);
            }
        }
    }
    return {};
}

} // namespace

std::optional<Eigen::Vector3d> findLeak(const Surface& surface, const InsideTest& inside,
                                        const VoxelLayout& layout, const VoxelBits& outer,
                                        double radius)
{
    const auto centreOf = [&](const Cube& c) { return layout.frame.centre(c[0], c[1], c[2]); };
    VoxelBits looked(layout.words, 0); // many small triangles lead to one cube
    for (std::uint32_t id = 0; id < surface.size(); ++id)
    {
        // Where the centre of a sphere would be that touches the triangle from inside.
        const auto& [a, b, c] = surface[id].corner;
        const Cube start =
            layout.frame.coordinates((a + b + c) / 3 + radius * surface.bound(id).normal);
        const VoxelWord cube = layout.at(start[0], start[1], start[2]);
        const bool isNew = (outer[cube.word] & ~looked[cube.word] & cube.bits) != 0;
        looked[cube.word] |= cube.bits;
        if (!isNew || !inside.contains(centreOf(start)))
        {
            continue;
        }
        // On the way out the winding number falls from one to nothing; a hole is where it is half.
        for (const Cube& step : shortestExit(layout, outer, start))
        {
            if (windingNumber(surface.mesh(), centreOf(step)) < kInsideFrom)
            {
                return centreOf(step);
            }
        }
    }
    return std::nullopt;
}

} // namespace frostfill
