// SPDX-License-Identifier: MIT
#include "simulation/contact/depenetration.hpp"

#include "base/random.hpp"
#include "simulation/world/world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

// A cube of 20 radii with one sphere at rest in its middle.
class DepenetrationTest : public ::testing::Test
{
protected:
    DepenetrationTest() { world.spheres.addResting({0, 0, 0}, 1, 0); }

    static Scene scene()
    {
        Scene result = presetScene(Preset::fast, "cube");
        result.spheres.count.reset();
        result.spheres.radius = 0.1;
        return result;
    }

    World world{scene(), builtInMesh("cube")};
    Eigen::Vector3d place = {0, 0, 0};
};

TEST_F(DepenetrationTest, IsFoundFromTheVeryPlaceOfAnother)
{
    ASSERT_TRUE(depenetrate(world, place, 1, 3));
    EXPECT_GE(place.norm(), 2);
    EXPECT_LT(place.norm(), 2.1);
}

TEST_F(DepenetrationTest, IsClearOfANewcomerAsIfThatWereAtRest)
{
    const PlacedSphere newcomer{{0, 2, 0}, 1};
    place = {0.2, 1.1, 0.1};
    Eigen::Vector3d same = place;
    ASSERT_TRUE(depenetrate(world, newcomer, place, 1, 3, 100));
    EXPECT_GE(place.norm(), 2);
    EXPECT_GE((place - newcomer.place).norm(), 2);
    EXPECT_EQ(world.spheres.resting().size(), 1U);

    world.spheres.addResting(newcomer.place, newcomer.radius, 0);
    ASSERT_TRUE(depenetrate(world, same, 1, 3, 100));
    EXPECT_LT((place - same).norm(), 1e-12);
}

TEST_F(DepenetrationTest, LeavesTheFloorByItsDepthHoweverShallow)
{
    for (const double depth : {1e-5, 0.01, 0.09, 0.5, 0.99})
    {
        place = {4, -9 - depth, 3};
        ASSERT_TRUE(depenetrate(world, place, 1, 3)) << depth;
        EXPECT_LT((place - Eigen::Vector3d(4, -9, 3)).norm(), 2 * kClearance) << depth;
    }
}

// The oracle: the walls are ten from the middle, and there is one sphere.
TEST_F(DepenetrationTest, IsClearOfAllWallsAndSpheresWhereverItStarted)
{
    int pushed = 0;
    for (std::uint64_t k = 0; k < 2000; ++k)
    {
        const auto draw = [k](std::uint64_t axis) { return 2 * uniformRandom(11, k, axis) - 1; };
        // In the middle or in a corner.
        const Eigen::Vector3d start = Eigen::Vector3d(draw(0), draw(1), draw(2)) +
                                      (k % 2 == 0 ? 0 : 9) * Eigen::Vector3d::Ones();
        place = start;
        ASSERT_TRUE(depenetrate(world, place, 1, 10, 100)) << start.transpose();
        EXPECT_LE(place.cwiseAbs().maxCoeff(), 9) << start.transpose();
        EXPECT_GE(place.norm(), 2) << start.transpose();
        pushed += place != start ? 1 : 0;
    }
    EXPECT_GT(pushed, 1500);
}

TEST_F(DepenetrationTest, IsNotFoundWithinTooShortAWay)
{
    EXPECT_FALSE(depenetrate(world, place, 1, 1));
}

} // namespace
} // namespace frostfill
