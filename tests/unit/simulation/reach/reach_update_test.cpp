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

TEST(ReachUpdate, UpdateEqualsAFreshFloodBitForBit)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed)
    {
        Random random(seed);
        // Wide enough for two words a row in some of them.
        const Object object(cubeOfSide(seed % 5 == 0 ? 30 : 10));
        const double half = object.surface.box().max().x() - 1;
        const ReachMap::Margins margins;
        ReachMap map(object.surface, object.inside, {1, 1}, margins);
        std::vector<Ball> balls;
        std::vector<Eigen::Vector3d> seeds;
        std::vector<Eigen::Vector3d> withdrawn;
        const auto pickSeeds = [&]
        {
            seeds.clear();
            for (int i = 0; i < 6; ++i)
            {
                const Eigen::Vector3d p = random.point(-half, half);
                if (map.contains(p))
                {
                    seeds.push_back(p);
                }
            }
            withdrawn.clear();
            map.setSeeds(seeds, 0);
        };
        pickSeeds();
        ASSERT_TRUE(map.flood({}));
        const int batch = half > 10 ? 60 : 3;
        for (int round = 0; round < 20; ++round)
        {
            const VoxelBits before = map.reached();
            for (int i = 0; i < batch; ++i)
            {
                balls.push_back({random.point(-half, half), 1});
                map.addResting(balls.back().centre, 1);
            }
            if (round % 7 == 6)
            {
                pickSeeds();
            }
            else if (round % 3 == 2 && !seeds.empty())
            {
                withdrawn.push_back(seeds.front());
                map.withdrawSeed(seeds.front());
            }
            std::vector<Eigen::Vector3d> running;
            const Eigen::Vector3d p = random.point(-half, half);
            if (map.contains(p))
            {
                running.push_back(p);
            }
            ASSERT_TRUE(map.update(running));

            ReachMap fresh(object.surface, object.inside, {1, 1}, margins);
            for (const Ball& ball : balls)
            {
                fresh.addResting(ball.centre, 1);
            }
            fresh.setSeeds(seeds, 0);
            for (const auto& w : withdrawn)
            {
                fresh.withdrawSeed(w);
            }
            ASSERT_TRUE(fresh.flood(running));
            ASSERT_EQ(map.reached(), fresh.reached()) << "seed " << seed << " round " << round;
            ASSERT_EQ(map.reachedCount(), fresh.reachedCount());

            // The cubes named as lost are those that went.
            VoxelBits rebuilt = map.reached();
            map.forEachLost(
                [&](const Eigen::Vector3d& middle)
                {
                    const VoxelWord w = map.layout().at(middle);
                    EXPECT_EQ(rebuilt[w.word] & w.bits, 0u);
                    rebuilt[w.word] |= w.bits;
                });
            ASSERT_EQ(rebuilt, before);
            for (const auto& box : map.lostBlocks())
            {
                EXPECT_NEAR(box.sizes().x(), 4 * map.layout().frame.cell, 1e-9);
            }
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

TEST(ReachUpdate, SealedPocketIsLostAndItsSpheresAreDroppable)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    map.seedAbove(3);
    ASSERT_TRUE(map.flood({}));
    map.addResting({0, -5, 0}, 1);
    addLayer(map, 6, 2);
    map.update({});
    EXPECT_TRUE(map.contains({0, -3, 0})) << "through the gap of four spheres";
    EXPECT_FALSE(map.sphereDroppable({0, -5, 0}, 1));

    addLayer(map, 6, -1);
    map.update({});
    EXPECT_FALSE(map.contains({0, -3, 0}));
    EXPECT_TRUE(map.contains({0, 3, 0}));
    EXPECT_TRUE(map.sphereDroppable({0, -5, 0}, 1));
    EXPECT_FALSE(map.sphereDroppable({1, 0, 1}, 1));
    EXPECT_FALSE(map.lostBlocks().empty());
}

TEST(ReachUpdate, RunningSphereKeepsItsPocketAndItsFreezingClosesIt)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    map.seedAbove(3);
    const std::vector<Eigen::Vector3d> running = {{0, -3, 0}};
    ASSERT_TRUE(map.flood(running));
    addLayer(map, 6, -1);
    EXPECT_TRUE(map.update(running));
    EXPECT_TRUE(map.contains({4, -3, 4}));
    EXPECT_TRUE(map.update({}));
    EXPECT_FALSE(map.contains({4, -3, 4}));
    EXPECT_FALSE(map.update(running)) << "a centre out of reach is a failed guard";
}

TEST(ReachUpdate, SeedsAtTheTopWithdrawnLeaveNothing)
{
    const Object object(cubeOfSide(12));
    ReachMap map(object.surface, object.inside, {1, 1}, ReachMap::Margins{});
    const std::vector<Eigen::Vector3d> site = {{0.2, 4.2, 0.2}};
    map.setSeeds(site, 0);
    ASSERT_TRUE(map.flood({}));
    EXPECT_GT(map.reachedCount(), 1000u);
    map.withdrawSeed(site[0]);
    map.update({});
    EXPECT_EQ(map.reachedCount(), 0u);
    EXPECT_TRUE(map.sphereDroppable({0, 0, 0}, 1));
}

} // namespace
} // namespace frostfill
