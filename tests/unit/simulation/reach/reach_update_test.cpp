// SPDX-License-Identifier: MIT
#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using reach::Ball;
using reach::cubeOfSide;
using reach::Object;
using reach::Random;

// Spheres come to rest at random places, runners come, go and move; half-way through no sphere will
// be released any more, so that the set falls into the pockets of the runners.
TEST(ReachUpdate, UpdateEqualsAFreshFloodBitForBit)
{
    Threads threads(3);
    for (std::uint64_t seed = 0; seed < 10; ++seed)
    {
        Random random(seed);
        // Wide enough for two words a row in some of them.
        const Object object(cubeOfSide(seed % 5 == 0 ? 30 : 10));
        const double half = object.surface.box().max().x() - 1;
        const ReachMap::Margins margins;
        ReachMap map(object.surface, object.inside, {1, 1}, margins);
        std::vector<Ball> balls;
        ASSERT_TRUE(map.flood({}));
        const int batch = half > 10 ? 60 : 3;
        constexpr int kRounds = 20;
        for (int round = 0; round < kRounds; ++round)
        {
            std::vector<frostfill::Ball> came; // many at once, on threads
            for (int i = 0; i < batch; ++i)
            {
                const Eigen::Vector3d p = random.point(-half, half);
                balls.push_back({p, 1});
                came.push_back({p.x(), p.y(), p.z(), 1});
            }
            map.addResting(BallSlabs(map.layout().frame, came, map.reachOf(1)), threads);
            const bool withdrawn = round >= kRounds / 2;
            if (round == kRounds / 2)
            {
                map.withdrawSeeds();
            }
            std::vector<Eigen::Vector3d> running;
            for (int i = 0; i < 4; ++i)
            {
                const Eigen::Vector3d p = random.point(-half, half);
                if (map.contains(p))
                {
                    running.push_back(p);
                }
            }
            const std::size_t before = map.reachedCount();
            ASSERT_TRUE(map.update(running));

            ReachMap fresh(object.surface, object.inside, {1, 1}, margins);
            for (const Ball& ball : balls)
            {
                fresh.addResting(ball.centre, 1);
            }
            if (withdrawn)
            {
                fresh.withdrawSeeds();
            }
            ASSERT_TRUE(fresh.flood(running));
            ASSERT_EQ(map.reached(), fresh.reached()) << "seed " << seed << " round " << round;
            ASSERT_EQ(map.reachedCount(), fresh.reachedCount());
            ASSERT_LE(map.reachedCount(), before) << "the set only shrinks";
        }
    }
}

// A layer of touching spheres, one at each point of a square lattice.
void addLayer(ReachMap& map, double half, double hole)
{
    for (double x = -half + 1; x < half; x += 2)
    {
        for (double z = -half + 1; z < half; z += 2)
        {
            if (std::abs(x) > hole || std::abs(z) > hole)
            {
                map.addResting({x, 0, z}, 1);
            }
        }
    }
}

const std::vector<Eigen::Vector3d> kAtTheTop = {{0.2, 4.2, 0.2}};

/// Of a cube in which only a sphere at the top runs, and none will be released.
void floodFromTheTop(ReachMap& map)
{
    map.withdrawSeeds();
    ASSERT_TRUE(map.flood(kAtTheTop));
    ASSERT_GT(map.reachedCount(), 1000u);
}

TEST(ReachUpdate, SealedPocketIsLostAndItsSpheresAreDroppable)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    floodFromTheTop(map);
    map.addResting({0, -5, 0}, 1);
    addLayer(map, 6, 2);
    EXPECT_TRUE(map.update(kAtTheTop));
    EXPECT_TRUE(map.contains({0, -3, 0})) << "through the gap of four spheres";
    EXPECT_FALSE(map.sphereDroppable({0, -5, 0}, 1));

    addLayer(map, 6, -1);
    EXPECT_TRUE(map.update(kAtTheTop));
    EXPECT_FALSE(map.contains({0, -3, 0}));
    EXPECT_TRUE(map.contains({0, 3, 0}));
    EXPECT_TRUE(map.sphereDroppable({0, -5, 0}, 1));
    EXPECT_FALSE(map.sphereDroppable({1, 0, 1}, 1));
}

TEST(ReachUpdate, PocketIsKeptWhereASphereMayYetBeReleased)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    ASSERT_TRUE(map.flood({}));
    addLayer(map, 6, -1);
    EXPECT_TRUE(map.update({}));
    EXPECT_TRUE(map.contains({0, -3, 0}));
    map.withdrawSeeds();
    EXPECT_TRUE(map.update(kAtTheTop));
    EXPECT_FALSE(map.contains({0, -3, 0}));
}

TEST(ReachUpdate, RunningSphereKeepsItsPocketAndItsFreezingClosesIt)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    floodFromTheTop(map);
    std::vector<Eigen::Vector3d> running = kAtTheTop;
    running.emplace_back(0, -3, 0);
    ASSERT_TRUE(map.update(running));
    addLayer(map, 6, -1);
    EXPECT_TRUE(map.update(running));
    EXPECT_TRUE(map.contains({4, -3, 4}));
    EXPECT_TRUE(map.update(kAtTheTop));
    EXPECT_FALSE(map.contains({4, -3, 4}));
    EXPECT_FALSE(map.update(running)) << "a centre out of reach is a failed guard";
}

TEST(ReachUpdate, WithdrawnSeedsLeaveNothingWhereNothingRuns)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    ASSERT_TRUE(map.flood({}));
    EXPECT_GT(map.reachedCount(), 1000u);
    map.withdrawSeeds();
    EXPECT_TRUE(map.update({}));
    EXPECT_EQ(map.reachedCount(), 0u);
    EXPECT_TRUE(map.sphereDroppable({0, 0, 0}, 1));
}

} // namespace
} // namespace frostfill
