// SPDX-License-Identifier: MIT
#include "simulation/contact/footprint.hpp"

#include "base/random.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

TEST(FootprintTest, OfNothingMeetsNothing)
{
    EXPECT_FALSE(Footprint().meets({0, 0, 0}, 1));
}

TEST(FootprintTest, OfABallMeetsSpheresWhoseSurfaceIsWithinIt)
{
    Footprint seen;
    seen.addBall({1, 2, 3}, 0.5);
    EXPECT_TRUE(seen.meets({1, 3.4999, 3}, 1));
    EXPECT_FALSE(seen.meets({1, 3.5001, 3}, 1));
    EXPECT_TRUE(seen.meets({1, 2.5, 3.5}, 0.3));
    EXPECT_FALSE(seen.meets({1, 2.7, 3.5}, 0.3));
    seen.clear();
    EXPECT_FALSE(seen.meets({1, 2, 3}, 1));
}

// The two would touch where the centre is lower by the root of 2^2 - 1.2^2, 1.6.
TEST(FootprintTest, OfAFallMeetsWhatItWouldTouchBeforeItsEnd)
{
    Footprint seen;
    seen.addFall({0, 10, 0}, 1, 2);
    EXPECT_TRUE(seen.meets({1.2, 0.4001, 0}, 1));
    EXPECT_FALSE(seen.meets({1.2, 0.3999, 0}, 1));
    EXPECT_TRUE(seen.meets({0, 6, 1.9999}, 1));
    EXPECT_FALSE(seen.meets({0, 6, 2.0001}, 1));
    EXPECT_FALSE(seen.meets({0, 10.5, 1.5}, 1)) << "it falls from below that";
    EXPECT_FALSE(seen.meets({0, 6, 1.6}, 0.5));
}

TEST(FootprintTest, OfAFallWithoutAnEndHasNone)
{
    Footprint seen;
    seen.addFall({0, 10, 0}, 1, -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(seen.meets({0, -1e6, 1.5}, 1));
}

/// Forty spheres at rest in a box, where they fall from places by chance.
class FootprintOfAPath : public ::testing::Test
{
protected:
    explicit FootprintOfAPath() : world(smallWorld(shapes::box({-6, -10, -6}, {6, 10, 6}, 3)))
    {
        falls.emplace(world->spheres.resting().frame(), world->triangles);
        for (int k = 0; k < 40; ++k)
        {
            add(pathFrom(chance()).first);
        }
    }

    /// By chance, high up.
    Eigen::Vector3d chance()
    {
        const auto coordinate = [&] { return 5 * (2 * uniformRandom(11, 0, draws_++) - 1); };
        const double x = coordinate();
        return {x, 8.5, coordinate()};
    }
    void add(const Eigen::Vector3d& place)
    {
        addResting(*world, place);
        falls->insert(place);
    }
    std::pair<Eigen::Vector3d, bool> pathFrom(Eigen::Vector3d p, Footprint* seen = nullptr)
    {
        NeighbourList around;
        const bool rests = DropAndRoll(*world, *falls)
                               .settle(p, 1, around, std::numeric_limits<double>::infinity(), seen);
        return {p, rests};
    }

    std::unique_ptr<World> world;
    std::optional<FallIndex> falls;

private:
    std::uint64_t draws_ = 0;
};

// The oracle is the path itself, found again: a further sphere outside of the footprint changes no
// bit of it.
TEST_F(FootprintOfAPath, MeetsEverySphereThatChangesThePath)
{
    int met = 0;
    int changed = 0;
    constexpr int kTries = 400;
    for (int k = 0; k < kTries; ++k)
    {
        const Eigen::Vector3d from = chance();
        Footprint seen;
        const auto before = pathFrom(from, &seen);
        Eigen::Vector3d newcomer = pathFrom(chance()).first;
        if (k % 2 == 0)
        {
            newcomer.y() = 6 - k % 7; // in the air, where paths fall
        }
        const std::uint32_t id = addResting(*world, newcomer);
        // The index of falls has no way back, but bits too many only cost time.
        falls->insert(newcomer);
        const bool differs = pathFrom(from) != before;
        world->spheres.wake(id);
        world->spheres.withdraw(id);
        world->spheres.closeRanks();
        const bool meets = seen.meets(newcomer, 1);
        ASSERT_TRUE(meets || !differs) << k;
        met += meets ? 1 : 0;
        changed += differs ? 1 : 0;
    }
    EXPECT_GT(changed, kTries / 20);
    EXPECT_LT(met, kTries / 2) << "what meets everything is no use";
}

} // namespace
} // namespace frostfill
