// SPDX-License-Identifier: MIT
// Crowds of clusters that do not touch, and strips that go on without each other.

#include "simulation/solver/tolerances.hpp"
#include "unit/simulation/solver/crowd_of_pile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace frostfill
{
namespace
{

class ClusteredCrowdTest : public testing::TestWithParam<int>
{
protected:
    [[nodiscard]] std::size_t strips() const { return static_cast<std::size_t>(GetParam()); }
};

TEST_P(ClusteredCrowdTest, CutsNoClusterOfAFew)
{
    CrowdOfPile all(strips(), clusters(1), 0.6);
    const Crowd& crowd = all.crowd;
    all.crowd.forEachStrip([&](std::size_t strip) { all.crowd.enlist(strip); });
    EXPECT_FALSE(crowd.stripsTouch());
    ASSERT_EQ(crowd.strips().size(), std::min<std::size_t>(strips(), 128 / kFewestInStrip));
    std::uint32_t pairs = 0;
    for (const Crowd::Strip& strip : crowd.strips())
    {
        EXPECT_GE(strip.end - strip.begin, 128 / crowd.strips().size() / 2) << "of equal numbers";
        for (std::uint32_t slot = strip.begin; slot < strip.end; ++slot)
        {
            EXPECT_FALSE(crowd.isShared(slot));
            pairs += static_cast<std::uint32_t>(crowd.near(slot).size());
        }
    }
    EXPECT_EQ(pairs, 128U);
}

// A cluster with many pairs for its members, beside 63 of two.
TEST_P(ClusteredCrowdTest, GivesEachStripAsManyPairsAsTheLargestClusterAllows)
{
    CrowdOfPile all(strips(), clusters(1, 12), 0.6);
    all.crowd.forEachStrip([&](std::size_t strip) { all.crowd.enlist(strip); });
    ASSERT_FALSE(all.crowd.stripsTouch());
    std::vector<std::size_t> loads;
    std::size_t largest = 0; // at least: of what is near one member of it, and that member
    for (const Crowd::Strip& strip : all.crowd.strips())
    {
        loads.push_back(strip.end - strip.begin);
        for (std::uint32_t slot = strip.begin; slot < strip.end; ++slot)
        {
            const std::size_t near = all.crowd.near(slot).size();
            loads.back() += near;
            largest = std::max(largest, (near + 1) * (near + 1));
        }
    }
    EXPECT_GE(largest, 12U * 12U) << "all of it are near one another";
    const std::size_t sum = std::accumulate(loads.begin(), loads.end(), std::size_t{0});
    EXPECT_EQ(sum, 63U * 4 + 12 * 12);
    // The largest is dealt first, and the others, which have 4 each, fill up the rest.
    std::sort(loads.begin(), loads.end());
    const bool alone = largest > sum / loads.size();
    if (alone)
    {
        EXPECT_EQ(loads.back(), largest);
        loads.pop_back();
    }
    EXPECT_LE(loads.back() - loads.front(), 4U);
}

TEST_P(ClusteredCrowdTest, CutsWhatHangsTogetherAndIsMoreThanItsShare)
{
    const bool several = strips() > 1;
    EXPECT_EQ(CrowdOfPile(strips()).crowd.stripsTouch(), several);
    const bool touch = CrowdOfPile(strips(), clusters(1, 60), 0.6).crowd.stripsTouch();
    EXPECT_EQ(touch, strips() >= 8) << "60 hang together, of 186 in 3 strips, or in 5";
    EXPECT_EQ(CrowdOfPile(strips(), clusters(1, 200), 0.6).crowd.stripsTouch(), several);
}

TEST_P(ClusteredCrowdTest, EndsInAllStripsWithTheSweepAfterWhichNoneGoesOn)
{
    for (const auto& places : {shakenPlaces(1), clusters(1)})
    {
        CrowdOfPile all(strips(), places, 0.6);
        const std::size_t count = all.crowd.strips().size();
        for (std::size_t longest = 0; longest < count; ++longest)
        {
            all.turns.start();
            std::vector<std::uint32_t> ends(count);
            all.crowd.forEachStrip(
                [&](std::size_t strip)
                {
                    // Each strip has its own reasons; one has some for longer.
                    const auto own = static_cast<std::uint32_t>(strip == longest ? 7 : strip % 3);
                    std::uint32_t sweep = 1;
                    while (!all.turns.isLast(strip, sweep, sweep <= own))
                    {
                        ++sweep;
                    }
                    ends[strip] = sweep;
                });
            EXPECT_EQ(ends, std::vector<std::uint32_t>(count, 8));
        }
    }
}

TEST_P(ClusteredCrowdTest, MovesClustersAsOneThreadMovesThem)
{
    for (const int longest : {2, 60, 200})
    {
        Pile alone(clusters(3, longest), {});
        Pile many(clusters(3, longest), {}, strips());
        for (int k = 0; k < 15; ++k)
        {
            alone.step();
            many.step();
            for (std::uint32_t row = 0; row < alone.running.size(); ++row)
            {
                ASSERT_EQ(alone.running.position[row], many.running.position[row]) << k;
                ASSERT_EQ(alone.running.velocity[row], many.running.velocity[row]) << k;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfStrips, ClusteredCrowdTest, testing::Values(1, 2, 3, 8, 16),
                         testing::PrintToStringParamName());

} // namespace
} // namespace frostfill
