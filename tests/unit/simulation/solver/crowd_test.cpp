// SPDX-License-Identifier: MIT
// Strips of a crowd that are taken at once, against one after another.

#include "base/random.hpp"
#include "simulation/solver/tolerances.hpp"
#include "unit/simulation/solver/crowd_of_pile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace frostfill
{
namespace
{

std::vector<double> unlikeRadii(std::uint64_t seed)
{
    std::vector<double> radii;
    for (std::uint64_t k = 0; k < 343; ++k)
    {
        radii.push_back(0.4 + 0.6 * uniformRandom(seed, k, 4));
    }
    return radii;
}

class CrowdTest : public testing::TestWithParam<int>
{
protected:
    [[nodiscard]] std::size_t strips() const { return static_cast<std::size_t>(GetParam()); }
};

TEST_P(CrowdTest, HasEachRunnerOnceTheLowestFirstInEachStrip)
{
    CrowdOfPile all(strips());
    const Crowd& crowd = all.crowd;
    all.crowd.forEachStrip([&](std::size_t strip) { all.crowd.enlist(strip); });
    ASSERT_EQ(crowd.strips().size(), std::min<std::size_t>(strips(), 343 / kFewestInStrip));
    std::vector<std::uint32_t> rows;
    std::vector<std::uint32_t> ranks;
    std::uint32_t next = 0;
    for (const Crowd::Strip& strip : crowd.strips())
    {
        EXPECT_EQ(strip.begin, next);
        next = strip.end;
        EXPECT_GE(strip.end - strip.begin, 343 / crowd.strips().size() / 2) << "of equal numbers";
        for (std::uint32_t slot = strip.begin; slot < strip.end; ++slot)
        {
            rows.push_back(crowd.row(slot));
            ranks.push_back(crowd.rank(slot));
            EXPECT_EQ(crowd[slot].position(), all.pile.running.position[crowd.row(slot)]);
            if (slot > strip.begin)
            {
                EXPECT_LE(crowd[slot - 1].y, crowd[slot].y);
                EXPECT_LT(crowd.rank(slot - 1), crowd.rank(slot));
            }
        }
    }
    EXPECT_EQ(next, 343U);
    for (std::vector<std::uint32_t>* numbers : {&rows, &ranks})
    {
        std::sort(numbers->begin(), numbers->end());
        for (std::uint32_t k = 0; k < 343; ++k)
        {
            ASSERT_EQ((*numbers)[k], k);
        }
    }
}

// What is no number is told of at the end of a step, not in its middle.
TEST(Crowd, HasTheLowestFirstWhereSomeHeightsAreNoNumbers)
{
    std::vector<Eigen::Vector3d> places = shakenPlaces(1);
    for (std::size_t k = 0; k < places.size(); k += 5)
    {
        places[k].y() = std::numeric_limits<double>::quiet_NaN();
    }
    CrowdOfPile all(1, places, 1);
    std::vector<std::uint32_t> rows(places.size());
    std::iota(rows.begin(), rows.end(), 0);
    all.crowd.gather(rows, {0, -1, 0});
    all.crowd.arrange();
    all.crowd.forEachStrip([&](std::size_t strip) { all.crowd.enlist(strip); });
    double before = -std::numeric_limits<double>::infinity();
    std::size_t finite = 0;
    for (std::uint32_t slot = 0; slot < all.crowd.size(); ++slot)
    {
        const double height = all.crowd[slot].y;
        if (std::isfinite(height))
        {
            EXPECT_LE(before, height);
            before = height;
            ++finite;
        }
    }
    EXPECT_EQ(finite, places.size() - (places.size() + 4) / 5);
}

TEST_P(CrowdTest, KnowsWhoIsNearLowerAndOfAnotherStrip)
{
    CrowdOfPile all(strips());
    const Crowd& crowd = all.crowd;
    all.crowd.forEachStrip([&](std::size_t strip) { all.crowd.enlist(strip); });
    for (const Crowd::Strip& strip : crowd.strips())
    {
        for (std::uint32_t slot = strip.begin; slot < strip.end; ++slot)
        {
            std::vector<std::uint32_t> near;
            bool shared = false;
            for (const Crowd::Near& one : crowd.near(slot))
            {
                near.push_back(crowd.row(one.slot));
                EXPECT_EQ(one.isLower != 0, crowd.rank(one.slot) < crowd.rank(slot));
                const bool inStrip = one.slot >= strip.begin && one.slot < strip.end;
                EXPECT_EQ(one.isForeign != 0, !inStrip);
                shared = shared || !inStrip;
            }
            EXPECT_EQ(near, all.pairs.nearby(crowd.row(slot)));
            EXPECT_EQ(crowd.isShared(slot), shared);
        }
    }
}

// What each member sees of those nearby is what it would see if all came one after another.
TEST_P(CrowdTest, GivesTurnsOfASweepInTheOrderOfOne)
{
    CrowdOfPile all(strips());
    std::vector<std::uint32_t> turnsHad(343, 0);
    all.crowd.forEachStrip(
        [&](std::size_t strip)
        {
            all.crowd.enlist(strip);
            all.turns.meet();
            for (std::uint32_t sweep = 1; sweep <= 20; ++sweep)
            {
                all.crowd.forEachMember(strip,
                                        [&](std::uint32_t slot)
                                        {
                                            all.turns.awaitLower(slot, sweep);
                                            if (sweep > 1)
                                            {
                                                all.turns.awaitUpper(slot, sweep - 1);
                                            }
                                            for (const Crowd::Near& near : all.crowd.near(slot))
                                            {
                                                EXPECT_EQ(turnsHad[near.slot],
                                                          near.isLower != 0 ? sweep : sweep - 1);
                                            }
                                            ++turnsHad[slot];
                                            all.turns.endTurn(slot, sweep);
                                        });
            }
        });
    EXPECT_EQ(std::count(turnsHad.begin(), turnsHad.end(), 20U), 343);
}

TEST_P(CrowdTest, GivesTurnsOfRoundsInTheOrderOfOne)
{
    constexpr std::uint32_t kRoundsHere = 6;
    // By row: the turns that have changed it, by round and row.
    using Log = std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>>;
    const auto logOf = [](std::size_t strips)
    {
        CrowdOfPile all(strips);
        Log log(343);
        all.crowd.forEachStrip(
            [&](std::size_t strip)
            {
                all.crowd.enlist(strip);
                all.turns.meet();
                all.turns.findTurns(strip);
                all.turns.meet();
                const auto change = [&](std::uint32_t slot, std::uint32_t round, std::uint32_t by)
                { log[all.crowd.row(slot)].emplace_back(round, all.crowd.row(by)); };
                for (std::uint32_t round = 0; round < kRoundsHere; ++round)
                {
                    all.crowd.forEachMember(strip,
                                            [&](std::uint32_t slot)
                                            {
                                                all.turns.awaitRound(slot, round);
                                                change(slot, round, slot);
                                                for (const Crowd::Near& near : all.crowd.near(slot))
                                                {
                                                    if (near.isLower != 0)
                                                    {
                                                        change(near.slot, round, slot);
                                                    }
                                                }
                                                all.turns.endRound(slot);
                                            });
                }
                // Whoever has had all its rounds is changed no more.
                all.crowd.forEachMember(
                    strip,
                    [&](std::uint32_t slot)
                    {
                        all.turns.awaitRounds(slot, kRoundsHere);
                        const auto& turns = log[all.crowd.row(slot)];
                        const auto isLast = [](const auto& turn)
                        { return turn.first == kRoundsHere - 1; };
                        const auto near = all.crowd.near(slot);
                        const auto above =
                            std::count_if(near.begin(), near.end(),
                                          [](const auto& one) { return one.isLower == 0; });
                        EXPECT_EQ(std::count_if(turns.begin(), turns.end(), isLast), above + 1);
                    });
            });
        return log;
    };
    EXPECT_EQ(logOf(strips()), logOf(1));
}

TEST_P(CrowdTest, MovesAsOneThreadMovesIt)
{
    for (const std::uint64_t seed : {1U, 2U, 3U})
    {
        for (const bool unlike : {false, true})
        {
            const std::vector<double> radii = unlike ? unlikeRadii(seed) : std::vector<double>();
            Pile alone(shakenPlaces(seed), radii);
            Pile many(shakenPlaces(seed), radii, strips());
            // Some do not give way.
            for (std::uint32_t row = 0; row < 343; row += 5)
            {
                alone.positionSolver.velocities().stopYielding(row);
                many.positionSolver.velocities().stopYielding(row);
            }
            for (int k = 0; k < 15; ++k)
            {
                alone.step();
                many.step();
                for (std::uint32_t row = 0; row < 343; ++row)
                {
                    ASSERT_EQ(alone.running.position[row], many.running.position[row]);
                    ASSERT_EQ(alone.running.velocity[row], many.running.velocity[row]);
                }
            }
        }
    }
}

TEST_P(CrowdTest, IsTakenApartAsByOneThread)
{
    Pile alone(shakenPlaces(4));
    Pile many(shakenPlaces(4), {}, strips());
    std::vector<std::uint32_t> some;
    for (std::uint32_t row = 0; row < 343; ++row)
    {
        if (row % 7 != 3)
        {
            some.push_back(row);
        }
    }
    for (Pile* pile : {&alone, &many})
    {
        pile->step();
        pile->positionSolver.separate(some);
        pile->positionSolver.separate();
    }
    for (std::uint32_t row = 0; row < 343; ++row)
    {
        ASSERT_EQ(alone.running.position[row], many.running.position[row]);
        for (const std::uint32_t other : many.positionSolver.pairs().nearby(row))
        {
            EXPECT_GT((many.running.position[row] - many.running.position[other]).norm(), 2 - 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfStrips, CrowdTest, testing::Values(1, 2, 3, 8, 16),
                         testing::PrintToStringParamName());

} // namespace
} // namespace frostfill
