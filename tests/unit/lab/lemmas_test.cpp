// SPDX-License-Identifier: MIT
#include "lab/operations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>

namespace frostfill
{
namespace
{

/// Counts the pairs one by one: spheres 0..n-1 in order, the last `running` run, the first
/// `discarded` are gone.
Operations countPairs(std::uint64_t n, std::uint64_t running, std::uint64_t discarded)
{
    Operations counted;
    for (std::uint64_t i = n - running; i < n; ++i)
    {
        for (std::uint64_t j = discarded; j < i; ++j)
        {
            ++counted.tests;
            counted.responses += j >= n - running ? 2 : 1;
        }
    }
    return counted;
}

void expectEqual(const Operations& a, const Operations& b)
{
    EXPECT_EQ(a.tests, b.tests);
    EXPECT_EQ(a.responses, b.responses);
}

TEST(Lemmas, BruteForceCountsEveryPair)
{
    expectEqual(bruteForce(0), {0, 0});
    expectEqual(bruteForce(1), {0, 0});
    expectEqual(bruteForce(30), countPairs(30, 30, 0));
}

TEST(Lemmas, Lemma1CountsTheLastGroupAgainstTheFrozenOnes)
{
    expectEqual(lemma1(1, 10, 0), countPairs(10, 10, 0));
    expectEqual(lemma1(7, 5, 0), countPairs(35, 5, 0));
    expectEqual(lemma1(7, 5, 4), countPairs(35, 5, 20));
    // The leading order of the sum, (2 beta - 1/2) gamma^2, for large groups.
    EXPECT_NEAR(static_cast<double>(lemma1(10, 10000, 0).sum()) / 1e8, 19.5, 0.001);
}

TEST(Lemmas, Lemma2CountsTheLastSetAgainstTheEarlierOnes)
{
    expectEqual(lemma2(9, 4, 3, 0), countPairs(36, 12, 0));
    expectEqual(lemma2(9, 4, 3, 2), countPairs(36, 12, 8));
    expectEqual(lemma2(8, 4, 1, 0), lemma1(8, 4, 0));
}

TEST(Lemmas, Lemma3TakesOffWhatEarlierSetsDiscarded)
{
    const std::array<std::uint64_t, 3> discarded = {5, 0, 7};
    // 20 spheres a set: 100, then 95, then 95 polygons.
    EXPECT_EQ(lemma3(10, 2, 100, discarded).tests, 20u * (100 + 95 + 95));
    EXPECT_EQ(lemma3(10, 2, 100, std::array<std::uint64_t, 4>{}).tests, 80u * 100);
}

} // namespace
} // namespace frostfill
