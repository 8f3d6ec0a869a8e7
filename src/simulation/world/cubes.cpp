// SPDX-License-Identifier: MIT
#include "simulation/world/cubes.hpp"

#include "mesh/interior/near_surface.hpp"

#include <atomic>

namespace frostfill
{

std::optional<Cubes> Cubes::inReach(const GridFrame& frame, const InsideTest& inside, double most,
                                    std::size_t whole)
{
    Cubes cubes;
    cubes.frame_ = frame;
    cubes.words_ = BrickedCells<1>({(frame.count[0] + 63) / 64, frame.count[1], frame.count[2]},
                                   std::min(whole, static_cast<std::size_t>(most)));
    const auto add = [&](const Eigen::AlignedBox3d& box)
    {
        if (static_cast<double>(cubes.words()) > most)
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
    if (!cubes.words_.isOne())
    {
        inside.forEachBoxInReach(add);
    }
    return static_cast<double>(cubes.words()) <= most ? std::optional(std::move(cubes))
                                                      : std::nullopt;
}

CubeSet Cubes::all() const
{
    CubeSet cubes(words());
    for (std::size_t word = 0; word < cubes.size(); ++word)
    {
        cubes[word] = inGrid(word);
    }
    return cubes;
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

// All threads take cubes out at once, each those near its triangles.
CubeSet cubesFartherThan(const Surface& surface, const Cubes& cubes, double distance, CubeSet among,
                         Threads& threads)
{
    const auto takeOutNear = [&](int y, int z, CellRun run, auto&& isNear)
    {
        forEachWordOf(run,
                      [&](int x, std::uint64_t bits)
                      {
                          const std::atomic_ref word(among[cubes.word(x, y, z)]);
                          std::uint64_t near = 0;
                          for (std::uint64_t left = bits & word.load(std::memory_order_relaxed);
                               left != 0; left &= left - 1)
                          {
                              near |= isNear(64 * x + std::countr_zero(left)) ? left & -left : 0;
                          }
                          if (near != 0)
                          {
                              word.fetch_and(~near, std::memory_order_relaxed);
                          }
                      });
    };
    forEachGroup(surface, cubes.frame().cell, threads,
                 [&](const TriangleGroup& group)
                 { forEachRunNear(cubes.frame(), surface, group, distance, takeOutNear); });
    return among;
}

// One test serves all that are connected.
CubeSet cubesInside(const Cubes& cubes, const InsideTest& inside, CubeSet among)
{
    CubeSet kept(cubes.words(), 0);
    for (std::size_t word = 0; word < among.size(); ++word)
    {
        while (among[word] != 0)
        {
            const CubeWord first{word, among[word] & -among[word]};
            bool isInside = false;
            cubes.forEachCube(first, [&](const GridPlace& cube)
                              { isInside = inside.isInsideByWinding(cubes.middle(cube)); });
            cubes.takeConnected(among, first,
                                [&](CubeWord found)
                                { kept[found.word] |= isInside ? found.bits : 0; });
        }
    }
    return kept;
}

} // namespace frostfill
