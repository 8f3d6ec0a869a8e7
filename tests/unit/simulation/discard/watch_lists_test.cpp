// SPDX-License-Identifier: MIT
#include "simulation/discard/watch_lists.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <map>

namespace frostfill
{
namespace
{

using Watchers = std::vector<WatchLists::Watcher>;

std::map<std::uint32_t, CubeNumber> asMap(const Watchers& watchers)
{
    std::map<std::uint32_t, CubeNumber> result;
    for (const auto& [obstacle, witness] : watchers)
    {
        EXPECT_TRUE(result.emplace(obstacle, witness).second) << obstacle << " twice";
    }
    return result;
}

TEST(WatchLists, WhoHasNoCubeYetFallsAtOnceAndOnlyOnce)
{
    Threads threads(1);
    WatchLists lists(3);
    lists.add({{2, kNoCube}, {0, kNoCube}, {1, kNoCube}});
    const auto isCube = [](CubeNumber cube) { return cube != kNoCube; };
    const Watchers fallen = lists.takeFallen(threads, isCube);
    ASSERT_EQ(fallen.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(fallen[i].obstacle, i);
        EXPECT_EQ(fallen[i].witness, kNoCube);
    }
    EXPECT_TRUE(lists.takeFallen(threads, isCube).empty());
    lists.add({{1, 5}});
    lists.add({{0, kNoCube}});
    EXPECT_EQ(lists.takeFallen(threads, isCube).size(), 1u);
}

TEST(WatchLists, AskForEachCubeOnceThoughManyWatchIt)
{
    Threads threads(1);
    WatchLists lists(1000);
    Watchers all;
    for (std::uint32_t i = 0; i < 1000; ++i)
    {
        all.push_back({i, i / 500});
    }
    lists.add(all);
    int asked = 0;
    EXPECT_TRUE(lists.takeFallen(threads, [&](CubeNumber) { return ++asked > 0; }).empty());
    EXPECT_EQ(asked, 2);
}

// The oracle is a witness for each obstacle.
TEST(WatchLists, GiveBackExactlyThoseWhoseCubeHasFallenOnAnyNumberOfThreads)
{
    constexpr std::uint32_t kCount = 500;
    for (const int count : {1, 3})
    {
        Threads threads(count);
        WatchLists lists(kCount);
        std::map<std::uint32_t, CubeNumber> expected;
        Watchers beginning;
        for (std::uint32_t i = 0; i < kCount; ++i)
        {
            beginning.push_back({i, kNoCube});
        }
        lists.add(beginning);
        std::uint64_t draws = 0;
        const auto random = [&](double most) { return most * uniformRandom(7, 0, draws++); };
        std::size_t fell = 0;
        for (int round = 0; round < 60; ++round)
        {
            const auto bad = static_cast<CubeNumber>(random(12));
            const auto stands = [&](CubeNumber cube)
            { return cube != kNoCube && cube % 12 != bad; };
            std::map<std::uint32_t, CubeNumber> still;
            std::map<std::uint32_t, CubeNumber> falling;
            for (const auto& one : expected)
            {
                (stands(one.second) ? still : falling).insert(one);
            }
            Watchers fallen = lists.takeFallen(threads, stands);
            EXPECT_TRUE(std::is_sorted(fallen.begin(), fallen.end(),
                                       [](auto& a, auto& b) { return a.obstacle < b.obstacle; }));
            if (round > 0)
            {
                ASSERT_EQ(asMap(fallen), falling);
            }
            fell += fallen.size();
            expected = still;
            Watchers again; // some are dropped for good
            for (const WatchLists::Watcher& one : fallen)
            {
                if (random(1) < 0.9)
                {
                    again.push_back({one.obstacle, static_cast<CubeNumber>(random(40))});
                    expected[one.obstacle] = again.back().witness;
                }
            }
            lists.add(again);
        }
        EXPECT_GT(fell, 1000u);
    }
}

} // namespace
} // namespace frostfill
