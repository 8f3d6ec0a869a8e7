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

/// The face by which a search came to each cube, three bits of one.
class Arrivals
{
public:
    static constexpr unsigned kUnseen = 0;
    static constexpr unsigned kStart = 7; ///< else 1 and the face

    explicit Arrivals(const VoxelLayout& layout) : layout_(layout)
    {
        bits_.fill(VoxelBits(layout.words, 0));
    }
    [[nodiscard]] unsigned at(const Cube& cube) const
    {
        const VoxelWord w = layout_.at(cube[0], cube[1], cube[2]);
        unsigned code = 0;
        for (unsigned k = 0; k < 3; ++k)
        {
            code |= (bits_[k][w.word] & w.bits) != 0 ? 1u << k : 0u;
        }
        return code;
    }
    void set(const Cube& cube, unsigned code) // of one that is unseen
    {
        const VoxelWord w = layout_.at(cube[0], cube[1], cube[2]);
        for (unsigned k = 0; k < 3; ++k)
        {
            bits_[k][w.word] |= (code >> k & 1u) != 0 ? w.bits : 0;
        }
    }

private:
    const VoxelLayout& layout_;
    std::array<VoxelBits, 3> bits_;
};

bool isInLayout(const VoxelLayout& layout, const Cube& cube)
{
    const auto& count = layout.frame.count;
    return cube[0] >= 0 && cube[0] < count[0] && cube[1] >= 0 && cube[1] < count[1] &&
           cube[2] >= 0 && cube[2] < count[2] &&
           !layout.isNowhere(layout.word(cube[0] / 64, cube[1], cube[2]));
}

// Breadth first: the cubes from `start` to the nearest one at the border.
std::vector<Cube> shortestExit(const VoxelLayout& layout, const VoxelBits& open, const Cube& start)
{
    Arrivals cameBy(layout);
    std::vector<Cube> queue = {start};
    cameBy.set(start, Arrivals::kStart);
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
        Cube here = queue[head];
        for (int face = 0; face < 6; ++face)
        {
            const int axis = face / 2;
            Cube next = here;
            next[axis] += face % 2 == 0 ? -1 : 1;
            if (!isInLayout(layout, next))
            {
                std::vector<Cube> way;
                while (cameBy.at(here) != Arrivals::kStart)
                {
                    way.push_back(here);
                    const int back = static_cast<int>(cameBy.at(here)) - 1;
                    here[back / 2] += back % 2 == 0 ? 1 : -1;
                }
                way.push_back(start);
                return {way.rbegin(), way.rend()};
            }
            if (isIn(layout, open, next) && cameBy.at(next) == Arrivals::kUnseen)
            {
                cameBy.set(next, 1 + static_cast<unsigned>(face));
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
