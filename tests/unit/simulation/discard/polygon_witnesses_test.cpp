// SPDX-License-Identifier: MIT
#include "simulation/discard/polygon_witnesses.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>

namespace frostfill
{
namespace
{

using Polygons = std::set<std::uint32_t>;

/// Of each polygon by itself, with all cubes, from the top.
Polygons untouchable(const ReachMap& map, const Surface& surface,
                     const PolygonWitnesses::MayHold& mayHold)
{
    Polygons result;
    for (std::uint32_t t = 0; t < surface.size(); ++t)
    {
        bool isNear = false;
        map.findNear({{&t, 1}, {}}, {}, mayHold, [&](std::size_t, VoxelWord) { isNear = true; });
        if (!isNear)
        {
            result.insert(t);
        }
    }
    return result;
}

// Cubes are lost in the map, as when it is cut off, and in what may hold a place.
TEST(PolygonWitnesses, GiveOutEachPolygonWhenNoCubeIsLeftForItOnAnyNumberOfThreads)
{
    const reach::Object object(shapes::torus(3, 1.5, 120, 60)); // many side by side
    for (const int count : {1, 3})
    {
        Threads threads(count);
        ReachMap map(object.surface, object.inside, {0.4, 0.4}, {}, {});
        ASSERT_TRUE(map.active() && map.flood({}));
        PolygonWitnesses witnesses(object.surface);
        reach::Random random(5);
        std::set<std::array<int, 3>> empty;
        const auto mayHold = [&](int x, int y, int z) { return !empty.contains({x, y, z}); };
        std::atomic<std::size_t> known = 0;
        const auto isHeld = [&](CubeNumber cube) // of some
        {
            bool is = false;
            map.layout().forEachCube(cubeOf(cube), [&](int x, int y, int z)
                                     { is = x % 2 == 0 && mayHold(x, y, z); });
            known += is ? 1 : 0;
            return is;
        };
        Polygons out;
        std::size_t rounds = 0; // in which some go, and some stay
        for (int round = 0; round < 30; ++round)
        {
            map.layout().forEachWord(
                [&](VoxelWord w)
                {
                    const VoxelWord reached = {w.word, map.reached()[w.word] & w.bits};
                    map.layout().forEachCube(reached,
                                             [&](int x, int y, int z)
                                             {
                                                 const double chance = random.uniform(0, 1);
                                                 if (chance < 0.1)
                                                 {
                                                     empty.insert({x, y, z});
                                                 }
                                                 else if (chance < 0.2)
                                                 {
                                                     map.closeCubes(map.layout().at(x, y, z));
                                                 }
                                             });
                });
            ASSERT_TRUE(map.update({}));
            for (const std::uint32_t polygon :
                 witnesses.takeUntouchable(map, threads, mayHold, isHeld))
            {
                EXPECT_TRUE(out.insert(polygon).second) << "twice";
            }
            const Polygons expected = untouchable(map, object.surface, mayHold);
            ASSERT_EQ(out, expected) << round;
            rounds += !out.empty() && out.size() < object.surface.size() ? 1 : 0;
        }
        EXPECT_GT(rounds, 5u);
        EXPECT_GT(known, 100u);
    }
}

} // namespace
} // namespace frostfill
