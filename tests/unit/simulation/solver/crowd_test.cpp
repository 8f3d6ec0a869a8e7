// SPDX-License-Identifier: MIT
// Crowds in slabs that are visited at the same time.

#include "base/random.hpp"
#include "simulation/solver/tolerances.hpp"
#include "unit/simulation/solver/pile.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace frostfill
{
namespace
{

constexpr double kRadius = 0.35;
constexpr std::uint32_t kLong = 20;
constexpr std::uint32_t kShort = 10;
constexpr std::uint32_t kHigh = 4;
constexpr std::uint32_t kAll = kLong * kShort * kHigh;

// As many as the tests ask for, however few cores there are.
const tbb::global_control kCrowdThreads(tbb::global_control::max_allowed_parallelism, 8);

/// Runners side by side, shaken, some pressed into others; the longer side along x or z.
std::vector<Eigen::Vector3d> crowdedPlaces(std::uint64_t seed, bool alongZ = false)
{
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t k = 0; k < kAll; ++k)
    {
        const auto at = [&](std::uint64_t n, std::uint32_t count, std::uint64_t axis)
        {
            const double middle = 0.5 * (count - 1);
            return kRadius * (1.95 * (static_cast<double>(n) - middle) +
                              0.4 * (uniformRandom(seed, k, axis) - 0.5));
        };
        const double x = at(k % kLong, kLong, 0);
        const double z = at(k / kLong % kShort, kShort, 2);
        const double y = at(k / kLong / kShort, kHigh, 1);
        places.emplace_back(alongZ ? z : x, y, alongZ ? x : z);
    }
    return places;
}

std::vector<double> radiiOfCrowd(std::uint64_t seed, bool unlike)
{
    std::vector<double> radii(kAll, kRadius);
    for (std::uint64_t k = 0; unlike && k < kAll; ++k)
    {
        radii[k] *= 0.5 + 0.5 * uniformRandom(seed, k, 4);
    }
    return radii;
}

/// A crowd of all runners of a pile.
struct CrowdOfPile
{
    explicit CrowdOfPile(const std::vector<Eigen::Vector3d>& places)
        : pile(places, std::vector<double>(places.size(), kRadius))
    {
        pairs.findPairs();
        crowd.gather({0, -1, 0});
    }

    Pile pile;
    BroadPhase pairs{pile.running, pile.threads};
    Crowd crowd{pile.running, pairs, pile.threads};
};

TEST(Crowd, HasEachRunnerOnceTheLowestFirstInEachSlab)
{
    const CrowdOfPile all(crowdedPlaces(1));
    const Crowd& crowd = all.crowd;
    EXPECT_GE(crowd.slabs().size(), kFewestSlabs);
    EXPECT_LE(crowd.slabs().size(), kAll / kFewestInSlab);
    std::set<std::uint32_t> rows;
    std::uint32_t next = 0;
    for (const Crowd::Slab& slab : crowd.slabs())
    {
        EXPECT_EQ(slab.begin, next);
        next = slab.end;
        for (std::uint32_t slot = slab.begin; slot < slab.end; ++slot)
        {
            rows.insert(crowd.row(slot));
            EXPECT_EQ(crowd[slot].position(), all.pile.running.position[crowd.row(slot)]);
            if (slot > slab.begin)
            {
                EXPECT_LE(crowd[slot - 1].y, crowd[slot].y);
            }
        }
    }
    EXPECT_EQ(next, kAll);
    EXPECT_EQ(rows.size(), kAll);
}

TEST(Crowd, KnowsNeighboursAndWhichAreLower)
{
    const CrowdOfPile all(crowdedPlaces(1));
    for (std::uint32_t slot = 0; slot < all.crowd.size(); ++slot)
    {
        std::vector<std::uint32_t> near;
        for (const Crowd::Near& one : all.crowd.near(slot))
        {
            near.push_back(all.crowd.row(one.slot));
            EXPECT_EQ(one.isLower != 0, all.crowd[one.slot].y < all.crowd[slot].y);
        }
        EXPECT_EQ(near, all.pairs.nearby(all.crowd.row(slot)));
    }
}

// Slabs at the same time: a member of another one is neither a neighbour nor has the same one.
TEST(Crowd, HasNoNeighbourInTwoSlabsAtTheSameTime)
{
    for (const bool alongZ : {false, true})
    {
        const CrowdOfPile all(crowdedPlaces(2, alongZ));
        const Crowd& crowd = all.crowd;
        ASSERT_GE(crowd.slabs().size(), kFewestSlabs) << "along the longer side";
        for (const std::size_t parity : {0U, 1U})
        {
            std::vector<std::size_t> touchedBy(crowd.size(), crowd.slabs().size());
            for (std::size_t k = parity; k < crowd.slabs().size(); k += 2)
            {
                const auto touch = [&](std::uint32_t slot)
                {
                    EXPECT_TRUE(touchedBy[slot] == crowd.slabs().size() || touchedBy[slot] == k);
                    touchedBy[slot] = k;
                };
                for (auto slot = crowd.slabs()[k].begin; slot < crowd.slabs()[k].end; ++slot)
                {
                    touch(slot);
                    for (const Crowd::Near& near : crowd.near(slot))
                    {
                        touch(near.slot);
                    }
                }
            }
        }
    }
}

TEST(Crowd, IsWholeWhereItIsSmallOrNarrowOrNotFinite)
{
    std::vector<Eigen::Vector3d> places = crowdedPlaces(3);
    std::vector<Eigen::Vector3d> column;
    for (const Eigen::Vector3d& p : places)
    {
        column.emplace_back(0.1 * p.x(), 10 * p.y(), 0.1 * p.z());
    }
    EXPECT_EQ(CrowdOfPile(column).crowd.slabs().size(), 1U);
    std::vector<Eigen::Vector3d> few = places;
    few.resize(kFewestSlabs * kFewestInSlab - 1);
    EXPECT_EQ(CrowdOfPile(few).crowd.slabs().size(), 1U);

    CrowdOfPile all(places);
    ASSERT_GT(all.crowd.slabs().size(), 1U);
    all.pile.running.position[700].x() = std::numeric_limits<double>::quiet_NaN();
    all.crowd.gather({0, -1, 0});
    EXPECT_EQ(all.crowd.slabs().size(), 1U);
}

// The guard finds what is not finite at the end of a step.
TEST(Crowd, HasTheLowestFirstWhereSomeHeightsAreNotFinite)
{
    std::vector<Eigen::Vector3d> places = crowdedPlaces(1);
    for (std::size_t k = 0; k < places.size(); k += 5)
    {
        places[k].y() = std::numeric_limits<double>::quiet_NaN();
    }
    CrowdOfPile all(places);
    std::vector<std::uint32_t> rows(places.size());
    std::iota(rows.begin(), rows.end(), 0);
    all.crowd.gather(rows, {0, -1, 0});
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

class CrowdTest : public testing::TestWithParam<int>
{
};

TEST_P(CrowdTest, MovesAsOneThreadMovesIt)
{
    for (const bool unlike : {false, true})
    {
        const std::vector<double> radii = radiiOfCrowd(1, unlike);
        Pile alone(crowdedPlaces(1), radii);
        Pile many(crowdedPlaces(1), radii, GetParam());
        // Some do not give way.
        for (std::uint32_t row = 0; row < kAll; row += 5)
        {
            alone.positionSolver.velocities().stopYielding(row);
            many.positionSolver.velocities().stopYielding(row);
        }
        for (int k = 0; k < 15; ++k)
        {
            alone.step();
            many.step();
            for (std::uint32_t row = 0; row < kAll; ++row)
            {
                ASSERT_EQ(alone.running.position[row], many.running.position[row]);
                ASSERT_EQ(alone.running.velocity[row], many.running.velocity[row]);
            }
        }
    }
}

TEST_P(CrowdTest, IsTakenApartAsByOneThread)
{
    Pile alone(crowdedPlaces(4), radiiOfCrowd(4, false));
    Pile many(crowdedPlaces(4), radiiOfCrowd(4, false), GetParam());
    std::vector<std::uint32_t> some;
    for (std::uint32_t row = 0; row < kAll; ++row)
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
    for (std::uint32_t row = 0; row < kAll; ++row)
    {
        ASSERT_EQ(alone.running.position[row], many.running.position[row]);
        for (const std::uint32_t other : many.positionSolver.pairs().nearby(row))
        {
            EXPECT_GT((many.running.position[row] - many.running.position[other]).norm(),
                      2 * kRadius - 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OnThreads, CrowdTest, testing::Values(2, 3, 8),
                         testing::PrintToStringParamName());

} // namespace
} // namespace frostfill
