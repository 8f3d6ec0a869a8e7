// SPDX-License-Identifier: MIT
#include "simulation/quality/heap_slope.hpp"

#include "base/random.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace frostfill
{
namespace
{

constexpr double kDegree = std::numbers::pi / 180;

/// Grains evenly over a disc, on a cone of this slope and below it.
std::vector<HeapGrain> cone(double slope, double foot, std::size_t count)
{
    std::vector<HeapGrain> grains;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        const double across = foot * std::sqrt(uniformRandom(7, k, 0));
        const double below = k % 2 == 0 ? 0 : uniformRandom(7, k, 1);
        grains.push_back({across, 2 * std::numbers::pi * (uniformRandom(7, k, 2) - 0.5),
                          (foot - across) * std::tan(slope) * (1 - below)});
    }
    return grains;
}

TEST(HeapSlope, IsThatOfACone)
{
    for (const double degrees : {0.0, 10.0, 25.0, 40.0})
    {
        const auto slope = heapSlope(cone(degrees * kDegree, 30, 20000), 1);
        ASSERT_TRUE(slope);
        EXPECT_NEAR(*slope / kDegree, degrees, 0.5);
    }
}

TEST(HeapSlope, LeavesOutTheRoundTopAndWhatHasRolledAway)
{
    std::vector<HeapGrain> grains = cone(25 * kDegree, 30, 20000);
    for (HeapGrain& grain : grains)
    {
        grain.top = std::min(grain.top, 25 * std::tan(25 * kDegree));
    }
    for (int k = 0; k < 800; ++k)
    {
        grains.push_back({31 + 0.02 * k, std::remainder(0.1 * k, 2 * std::numbers::pi), 2});
    }
    const auto slope = heapSlope(grains, 1);
    ASSERT_TRUE(slope);
    EXPECT_NEAR(*slope / kDegree, 25, 1);
}

TEST(HeapSlope, IsUnknownOfAFewGrains)
{
    EXPECT_FALSE(heapSlope({}, 1));
    EXPECT_FALSE(heapSlope(cone(25 * kDegree, 5, 1000), 1));
    EXPECT_FALSE(heapSlope(std::vector<HeapGrain>{{30, 0, 1}, {20, 0, 1}}, 1));
}

TEST(HeapSlope, TellsTheHeapsOfTwoInletsApart)
{
    const auto world = smallWorld(shapes::box({-40, -10, -20}, {40, 20, 20}));
    world->scene.spheres.inlets = {{{-20, 18, 0}, 4}, {{20, 18, 0}, 4}};
    for (const HeapGrain& grain : cone(30 * kDegree, 18, 12000))
    {
        for (const double middle : {-20.0, 20.0})
        {
            const double height = middle < 0 ? grain.top : grain.top / 2;
            world->spheres.addResting({middle + grain.across * std::cos(grain.azimuth), height - 10,
                                       grain.across * std::sin(grain.azimuth)},
                                      1, 0);
        }
    }
    const std::vector<HeapReport> heaps = heapsOf(*world);
    ASSERT_EQ(heaps.size(), 2U);
    EXPECT_EQ(heaps[0].spheres, 12000U);
    ASSERT_TRUE(heaps[0].slope && heaps[1].slope);
    EXPECT_NEAR(*heaps[0].slope, 30, 1);
    EXPECT_NEAR(*heaps[1].slope, 16.1, 1); // half as high
}

} // namespace
} // namespace frostfill
