// SPDX-License-Identifier: MIT
#include "simulation/reach/ball_slabs.hpp"

#include "base/random.hpp"
#include "simulation/reach/voxel_layout.hpp"
#include "simulation/reach/voxel_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace frostfill
{
namespace
{

class BallSlabsTest : public ::testing::Test
{
protected:
    BallSlabsTest()
    {
        for (std::uint64_t k = 0; k < 500; ++k)
        {
            const auto at = [&](std::uint64_t axis) { return 30 * uniformRandom(3, k, axis); };
            balls.push_back({at(0), at(1), at(2), 0.2 + 0.8 * uniformRandom(3, k, 3)});
        }
    }

    GridFrame frame = GridFrame::cover(
        Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(30, 30, 30)), 0.7, 3);
    std::vector<Ball> balls;
};

TEST_F(BallSlabsTest, HaveEachBallOnceAndInTheOrderGiven)
{
    const BallSlabs slabs(frame, balls, 2);
    std::vector<double> all;
    for (int slab = 0; slab < slabs.count(); ++slab)
    {
        std::size_t last = 0;
        for (const Ball& ball : slabs.slab(slab))
        {
            all.push_back(ball.x);
            const auto given = std::find_if(balls.begin(), balls.end(),
                                            [&](const Ball& one) { return one.x == ball.x; });
            const auto number = static_cast<std::size_t>(given - balls.begin());
            EXPECT_GE(number, last);
            last = number;
        }
    }
    std::vector<double> given;
    for (const Ball& ball : balls)
    {
        given.push_back(ball.x);
    }
    std::sort(all.begin(), all.end());
    std::sort(given.begin(), given.end());
    EXPECT_EQ(all, given);
}

// Slabs that are worked on at the same time: every other one.
TEST_F(BallSlabsTest, ShareNoLayerOfCubesWithTheNextButOne)
{
    const BallSlabs slabs(frame, balls, 2);
    ASSERT_GT(slabs.count(), 3);
    std::vector<std::set<int>> layers(static_cast<std::size_t>(slabs.count()));
    for (int slab = 0; slab < slabs.count(); ++slab)
    {
        for (const Ball& ball : slabs.slab(slab))
        {
            const BallRows rows(frame, ball.position(), ball.radius + 1, kMeetsBall);
            rows.window().forEach([&](int, int z)
                                  { layers[static_cast<std::size_t>(slab)].insert(z); });
        }
    }
    ASSERT_FALSE(layers[3].empty());
    for (std::size_t slab = 2; slab < layers.size() && !layers[slab].empty(); ++slab)
    {
        for (std::size_t other = 0; other + 1 < slab; ++other)
        {
            ASSERT_FALSE(layers[other].empty());
            EXPECT_LT(*layers[other].rbegin(), *layers[slab].begin()) << slab;
        }
    }
}

TEST_F(BallSlabsTest, AreOneAtLeast)
{
    const BallSlabs slabs(frame, {}, 1000);
    EXPECT_EQ(slabs.count(), 1);
    EXPECT_TRUE(slabs.slab(0).empty());
}

} // namespace
} // namespace frostfill
