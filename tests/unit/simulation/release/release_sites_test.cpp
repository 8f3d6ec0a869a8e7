// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/release/releases.hpp"

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

    Scene scene = presetScene(Preset::fast, "cube");
    TriangleMesh mesh = builtInMesh("cube");
};

TEST_F(ReleaseSitesTest, LookingAheadOnTwoThreadsFindsTheSamePlaces)
{
    World world(scene, mesh);
    const DropAndRoll descent(world);
    Threads one(1);
    Threads two(2);
    Releases plain(world, 4, one);
    Releases ahead(world, 4, two);
    ReleaseQuery query;
    query.ahead = 128;
    query.prepare = [&](Eigen::Vector3d& p, double radius, Eigen::AlignedBox3d& seen)
    {
        descent.drop(p, radius, &seen);
        return true;
    };
    // A third of the places do not suit, as where others run; which ones, the place decides.
    query.suits = [](const Eigen::Vector3d& p, double)
    { return std::fmod(std::abs(p.x()) * 1e3, 3.0) > 1; };
    std::size_t found = 0;
    for (;; ++found)
    {
        const auto place = plain.place(1, query);
        const auto other = ahead.place(1, query);
        ASSERT_EQ(place, other) << found;
        if (!place)
        {
            break;
        }
        if (found % 40 == 0)
        {
            world.spheres.addResting(*place, 1, 0);
            plain.close(*place, 1);
            ahead.close(*place, 1);
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
    ReleaseQuery query;
    query.givesUp = true;
    query.suits = [&](const Eigen::Vector3d&, double)
    {
        ++asked;
        return false;
    };
    EXPECT_FALSE(sites.find(1, query));
    EXPECT_EQ(asked, kMaxMisses);
    EXPECT_TRUE(sites.any());
}

// No step ends before its search has ended.
TEST_F(ReleaseSitesTest, EndsASearchSoonAfterItIsToldToAndForgetsNothing)
{
    World world(scene, mesh);
    Threads threads(1);
    for (const double band : {-1.0, 4.0}) // in the order of the lattice, and below ceilings
    {
        Releases releases(world, band, threads);
        int asked = 0;
        bool stays = true;
        const StopRequest stop{[&] { return asked >= 20; }};
        ReleaseQuery query;
        query.suits = [&](const Eigen::Vector3d&, double)
        {
            ++asked;
            return false;
        };
        query.prepare = [&](Eigen::Vector3d&, double, Eigen::AlignedBox3d&)
        {
            asked += stays ? 0 : 1;
            return stays;
        };
        query.stop = &stop;
        for (const bool stay : {true, false}) // places that do not suit now, or never
        {
            stays = stay;
            asked = 0;
            EXPECT_FALSE(releases.next(query));
            EXPECT_LE(asked, 20);
            EXPECT_TRUE(releases.any());
        }
    }
}

// The oracle is random points of the room that the walls leave: the largest gap among them.
TEST_F(ReleaseSitesTest, LeavesNoPlaceInAnObjectThatIsFull)
{
    World world(scene, mesh);
    Threads threads(2);
    ReleaseSites sites(world, 1, 4, threads);
    const ReleaseQuery any = {.suits = [](const Eigen::Vector3d&, double) { return true; }};
    while (const auto found = sites.find(1, any))
    {
        world.spheres.addResting(*found, 1, 0);
        sites.close(*found, 1);
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
