// SPDX-License-Identifier: MIT
#include "simulation/discard/held_cubes.hpp"

#include "base/random.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// A box with a sphere at rest in its middle; the search itself is the oracle.
class HeldCubesTest : public ::testing::Test
{
protected:
    HeldCubesTest()
        : world(smallWorld(shapes::box({-4, -4, -4}, {4, 4, 4}))),
          layout(GridFrame::cover(world->surface.box(), 0.69, 2)),
          search(world->spheres.resting(), world->surface, world->triangles, 1, 1e-3)
    {
        rest({0, 0, 0});
    }

    Ball rest(const Eigen::Vector3d& place)
    {
        addResting(*world, place);
        return {place.x(), place.y(), place.z(), 1};
    }
    template <class Visit>
    void forEachCube(Visit&& visit) const
    {
        const auto& [nx, ny, nz] = layout.frame.count;
        for (int z = 0; z < nz; ++z)
        {
            for (int y = 0; y < ny; ++y)
            {
                for (int x = 0; x < nx; ++x)
                {
                    visit(x, y, z);
                }
            }
        }
    }
    [[nodiscard]] bool searched(int x, int y, int z) const
    {
        return search.mayBeClear(layout.frame.centre(x, y, z), layout.frame.cell);
    }

    std::unique_ptr<World> world;
    VoxelLayout layout;
    ClearSearch search;
};

TEST_F(HeldCubesTest, AnswerAsTheSearchOnAnyThread)
{
    HeldCubes cubes(layout, search);
    Threads threads(4);
    const auto planes = static_cast<std::size_t>(layout.frame.count[2]);
    for (int round = 0; round < 2; ++round)
    {
        std::vector<int> wrong(4 * planes, 0);
        threads.forEachLarge(4 * planes, // each plane is asked for four times, maybe at once
                             [&](std::size_t i)
                             {
                                 const int z = static_cast<int>(i / 4);
                                 for (int y = 0; y < layout.frame.count[1]; ++y)
                                 {
                                     for (int x = 0; x < layout.frame.count[0]; ++x)
                                     {
                                         wrong[i] += cubes.mayHold(x, y, z) != searched(x, y, z);
                                     }
                                 }
                             });
        EXPECT_EQ(wrong, std::vector<int>(4 * planes, 0));
    }
}

TEST_F(HeldCubesTest, AreKnownToHoldOnceFoundSoUntilSomethingComesToRest)
{
    HeldCubes cubes(layout, search);
    const auto known = [&](int x, int y, int z)
    { return cubes.isHeld(numberOf(layout.at(x, y, z))); };
    int held = 0;
    forEachCube(
        [&](int x, int y, int z)
        {
            EXPECT_FALSE(known(x, y, z)) << "before it is asked for";
            const bool holds = cubes.mayHold(x, y, z);
            EXPECT_EQ(known(x, y, z), holds);
            held += known(x, y, z) ? 1 : 0;
        });
    EXPECT_GT(held, 100);
    Threads threads(2);
    const std::vector<Ball> came = {rest({2, 0, 0})};
    cubes.forgetNear(BallSlabs(layout.frame, came, 2), 1, threads);
    forEachCube(
        [&](int x, int y, int z)
        {
            // So a place that is known is there still.
            EXPECT_LE(known(x, y, z), searched(x, y, z)) << x << " " << y << " " << z;
            held -= known(x, y, z) ? 1 : 0;
        });
    EXPECT_GT(held, 0) << "forgotten beside the sphere";
}

TEST_F(HeldCubesTest, HandOverWhatWasFoundEmptyOnce)
{
    HeldCubes cubes(layout, search);
    std::size_t empty = 0;
    forEachCube([&](int x, int y, int z) { empty += cubes.mayHold(x, y, z) ? 0 : 1; });
    std::size_t drained = 0;
    std::size_t last = 0;
    cubes.drainEmpty(
        [&](VoxelWord words)
        {
            drained += static_cast<std::size_t>(std::popcount(words.bits));
            EXPECT_GT(words.word, last);
            last = words.word;
        });
    EXPECT_GT(empty, 100u);
    EXPECT_EQ(drained, empty);
    cubes.drainEmpty([](VoxelWord) { FAIL() << "twice"; });
}

// One after another, so that words of which some cubes were handed over get further ones.
TEST_F(HeldCubesTest, HandOverEachOfAWordThatIsFoundEmptyAfterAnother)
{
    HeldCubes cubes(layout, search);
    forEachCube(
        [&](int x, int y, int z)
        {
            const bool empty = !cubes.mayHold(x, y, z);
            std::size_t drained = 0;
            cubes.drainEmpty(
                [&](VoxelWord words)
                {
                    ++drained;
                    EXPECT_EQ(words.word, layout.at(x, y, z).word);
                    EXPECT_EQ(words.bits, layout.at(x, y, z).bits);
                });
            EXPECT_EQ(drained, empty ? 1u : 0u);
        });
}

TEST_F(HeldCubesTest, LookAgainWhereSomethingHasComeToRest)
{
    HeldCubes cubes(layout, search);
    forEachCube([&](int x, int y, int z) { (void)cubes.mayHold(x, y, z); });
    cubes.drainEmpty([](VoxelWord) {});
    const std::vector<Ball> came = {rest({2, 0, 0}), rest({-2, 0.5, 0})};
    Threads threads(2);
    cubes.forgetNear(BallSlabs(layout.frame, came, 2), 1, threads);
    int changed = 0;
    forEachCube(
        [&](int x, int y, int z)
        {
            const bool holds = searched(x, y, z);
            EXPECT_EQ(cubes.mayHold(x, y, z), holds) << x << " " << y << " " << z;
            changed += holds ? 0 : 1;
        });
    EXPECT_GT(changed, 0);
    // One after another, at random: each is told by itself.
    for (std::uint64_t k = 0; k < 30; ++k)
    {
        const auto at = [&](std::uint64_t axis) { return 6 * uniformRandom(1, k, axis) - 3; };
        const std::vector<Ball> one = {rest({at(0), at(1), at(2)})};
        cubes.forgetNear(BallSlabs(layout.frame, one, 2), 1, threads);
        forEachCube([&](int x, int y, int z)
                    { EXPECT_EQ(cubes.mayHold(x, y, z), searched(x, y, z)) << "ball " << k; });
    }
    search.halve(7);
    cubes.forgetAll();
    forEachCube([&](int x, int y, int z) { EXPECT_EQ(cubes.mayHold(x, y, z), searched(x, y, z)); });
}

} // namespace
} // namespace frostfill
