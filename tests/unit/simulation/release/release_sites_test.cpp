// SPDX-License-Identifier: MIT
#include "simulation/release/release_sites.hpp"

#include "base/random.hpp"
#include "simulation/motion/drop_and_roll.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

// A cube of 20 radii: some 1,000 spheres.
class ReleaseSitesTest : public ::testing::Test
{
protected:
    ReleaseSitesTest()
    {
        scene.spheres.count.reset();
        scene.spheres.radius = 0.1;
    }

    /// Puts a sphere at rest where `place` falls to.
    static void rest(World& world, FallIndex& falls, const Eigen::Vector3d& place)
    {
        world.spheres.addResting(place, 1, 0);
        falls.insert(place);
    }

    Scene scene = presetScene(Preset::fast, "cube");
    TriangleMesh mesh = builtInMesh("cube");
};

TEST_F(ReleaseSitesTest, LookingAheadOnTwoThreadsFindsTheSamePlaces)
{
    World world(scene, mesh);
    FallIndex falls(world.spheres.resting().frame(), world.triangles);
    const DropAndRoll descent(world, falls);
    Threads one(1);
    Threads two(2);
    ReleaseSites plain(world, 1, 4, one);
    ReleaseSites ahead(world, 1, 4, two);
    const auto fall = [&](Eigen::Vector3d p)
    {
        descent.drop(p, 1);
        return p;
    };
    // A third of the places do not suit, as where others run; which ones, the place decides.
    const auto suits = [](const Eigen::Vector3d& p)
    { return std::fmod(std::abs(p.x()) * 1e3, 3.0) > 1; };
    std::size_t found = 0;
    for (;; ++found)
    {
        const auto place = plain.find(fall, suits);
        const auto other = ahead.find(fall, suits, true);
        ASSERT_EQ(place, other) << found;
        if (!place)
        {
            break;
        }
        if (found % 40 == 0)
        {
            rest(world, falls, *place);
            plain.close(*place, 1);
            ahead.close(*place, 1);
            ahead.clearLookahead();
        }
        if (found == 40 * 700)
        {
            break;
        }
    }
    EXPECT_GT(found, 10000u);
}

// Each place costs a fall through the object, and there are thousands.
TEST_F(ReleaseSitesTest, GivesUpForNowWhenManyPlacesInARowDoNotSuit)
{
    World world(scene, mesh);
    Threads threads(1);
    ReleaseSites sites(world, 1, -1, threads);
    int asked = 0;
    const auto asItIs = [](const Eigen::Vector3d& p) { return p; };
    EXPECT_FALSE(sites.find(
        asItIs,
        [&](const Eigen::Vector3d&)
        {
            ++asked;
            return false;
        },
        false, true));
    EXPECT_EQ(asked, kMaxMisses);
    EXPECT_TRUE(sites.any());
}

// The oracle is random points of the room that the walls leave: the largest gap among them.
TEST_F(ReleaseSitesTest, LeavesNoPlaceInAnObjectThatIsFull)
{
    World world(scene, mesh);
    FallIndex falls(world.spheres.resting().frame(), world.triangles);
    Threads threads(2);
    ReleaseSites sites(world, 1, 4, threads);
    const auto asItIs = [](const Eigen::Vector3d& p) { return p; };
    const auto any = [](const Eigen::Vector3d&) { return true; };
    while (const auto place = sites.find(asItIs, any))
    {
        rest(world, falls, *place);
        sites.close(*place, 1);
    }
    ASSERT_GT(world.spheres.size(), 500u); // hanging where they are, less dense than fallen ones
    std::uint64_t draw = 0;
    const auto coordinate = [&] { return 9 * (2 * uniformRandom(7, 0, draw++) - 1); };
    for (int point = 0; point < 200000; ++point)
    {
        const double x = coordinate();
        const double y = coordinate();
        const Eigen::Vector3d p(x, y, coordinate());
        double nearest = std::numeric_limits<double>::infinity();
        const SphereGrid& resting = world.spheres.resting();
        resting.forEachNear(p, 2,
                            [&](std::uint32_t row)
                            { nearest = std::min(nearest, (resting[row].position() - p).norm()); });
        ASSERT_LT(nearest, 2 + 1e-6) << p.transpose();
    }
}

} // namespace
} // namespace frostfill
