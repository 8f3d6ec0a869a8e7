// SPDX-License-Identifier: MIT
#include "simulation/release/lookahead.hpp"

#include "simulation/release/releases.hpp"
#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>

namespace frostfill
{
namespace
{

Draw& findOut(Draw& draw, const Eigen::Vector3d& at)
{
    draw.place = at;
    draw.isLookedAt = true;
    draw.isKnown = true;
    draw.stays = true;
    draw.seen.addBall(at, 1);
    return draw;
}

TEST(LookaheadTest, KnowsADrawOnlyOfItsSiteAndRadius)
{
    Lookahead ahead;
    EXPECT_EQ(ahead.find({7, 3, 1}), nullptr);
    EXPECT_FALSE(ahead.expect({7, 3, 1}).isKnown);
    EXPECT_EQ(ahead.find({7, 3, 1}), nullptr) << "it is not found out yet";
    const Draw& draw = findOut(ahead.expect({7, 3, 1}), {0, 0, 0});
    EXPECT_EQ(ahead.find({7, 3, 1}), &draw);
    EXPECT_EQ(ahead.find({7, 4, 1}), nullptr);
    EXPECT_EQ(ahead.find({7, 3, 0.9}), nullptr);
    EXPECT_EQ(ahead.find({8, 3, 1}), nullptr);
    EXPECT_EQ(&ahead.expect({7, 3, 1}), &draw);
    EXPECT_TRUE(draw.isKnown);
    EXPECT_FALSE(ahead.expect({7, 4, 1}).isKnown) << "another ceiling is drawn now";
}

TEST(LookaheadTest, ForgetsDrawsToComeThatASphereAtRestMayChange)
{
    Lookahead ahead;
    for (std::uint64_t number = 1; number <= 4; ++number)
    {
        findOut(ahead.expect({number, 0, 1}), {10.0 * static_cast<double>(number), 0, 0});
    }
    ahead.voidNear({30, 1.5, 0}, 1, 1);
    EXPECT_TRUE(ahead.find({2, 0, 1}));
    EXPECT_FALSE(ahead.find({3, 0, 1}));
    EXPECT_TRUE(ahead.find({4, 0, 1}));
    ahead.voidNear({20, 1.5, 0}, 1, 2);
    EXPECT_TRUE(ahead.find({2, 0, 1})) << "it has been taken";
    EXPECT_FALSE(ahead.expect({3, 0, 1}).isLookedAt) << "it is looked at anew";
}

struct Rain
{
    const char* name;
    TriangleMesh mesh;
    Motion motion;
    double smallest;
};

std::ostream& operator<<(std::ostream& out, const Rain& rain)
{
    return out << rain.name;
}

class LookingAhead : public ::testing::TestWithParam<Rain>
{
protected:
    [[nodiscard]] static std::string hash(std::uint64_t seed, int threads)
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.motion.mode = GetParam().motion;
        scene.spheres.count.reset();
        scene.spheres.radius = Radii(GetParam().smallest, 0.12);
        scene.seed = seed;
        scene.threads = threads;
        Simulation simulation(scene, GetParam().mesh);
        while (simulation.step())
        {
        }
        return simulation.stateHash();
    }
};

// One thread never looks ahead: it is the oracle.
TEST_P(LookingAhead, ChangesNoBit)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
    {
        const std::string alone = hash(seed, 1);
        for (const int threads : {2, 3, 16})
        {
            EXPECT_EQ(hash(seed, threads), alone) << "seed " << seed << ", " << threads;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Objects, LookingAhead,
    ::testing::Values(Rain{"BoxDescend", shapes::box({-1, -1, -1}, {1, 1, 1}, 3), Motion::descend,
                           0.12},
                      Rain{"BoxSkip", shapes::box({-1, -1, -1}, {1, 1, 1}, 3), Motion::skip, 0.12},
                      Rain{"TorusDescend", shapes::torus(), Motion::descend, 0.12},
                      Rain{"TorusFall", shapes::torus(), Motion::fall, 0.12},
                      Rain{"MixedDescend", shapes::torus(), Motion::descend, 0.08},
                      Rain{"MixedSkip", shapes::torus(), Motion::skip, 0.08}),
    [](const auto& about) { return about.param.name; });

/// What a release rule finds when every place is taken at once, and how much of it was found out
/// on other threads ahead of its time.
class ReleasesAhead : public ::testing::Test
{
protected:
    ReleasesAhead()
    {
        scene.spheres.count.reset();
        scene.spheres.radius = 0.1;
    }
    static ReleaseQuery queryAhead(std::size_t ahead, bool suits)
    {
        ReleaseQuery query;
        query.ahead = ahead;
        query.suits = [suits](const Eigen::Vector3d&, double) { return suits; };
        return query;
    }
    Scene scene = presetScene(Preset::fast, "cube");
    TriangleMesh mesh = builtInMesh("cube");
};

// Counted by calls of prepare: what is found out twice is work for nothing.
TEST_F(ReleasesAhead, FindLittleOutTwice)
{
    World world(scene, mesh);
    Threads threads(3);
    Releases releases(world, world.height, threads);
    std::atomic<int> prepared = 0;
    ReleaseQuery query = queryAhead(16, true);
    // Straight down to the floor, so that ever more places are in the way of each other.
    query.prepare = [&](Eigen::Vector3d& place, double radius, Footprint& seen)
    {
        ++prepared;
        seen.addFall(place, radius, -9);
        return true;
    };
    int found = 0;
    while (const auto next = releases.next(query))
    {
        releases.close(next->place, next->radius);
        world.spheres.addResting(next->place, next->radius, 0);
        ++found;
    }
    EXPECT_GT(found, 500); // hanging where they appear
    EXPECT_LT(prepared, 2 * found);
}

// What does not suit in a search is not asked for again in it, and may suit in the next.
TEST_F(ReleasesAhead, AskOnceInASearchWhetherAPlaceSuits)
{
    World world(scene, mesh);
    Threads threads(3);
    Releases releases(world, world.height, threads);
    std::atomic<int> asked = 0;
    ReleaseQuery query = queryAhead(64, false);
    query.givesUp = true;
    query.suits = [&](const Eigen::Vector3d&, double)
    {
        ++asked;
        return false;
    };
    const auto count = [&](std::uint64_t search)
    {
        asked = 0;
        query.search = search;
        EXPECT_FALSE(releases.next(query));
        return asked.load();
    };
    const int once = count(1);
    EXPECT_GE(once, 2 * kMaxMisses) << "high places, then others";
    EXPECT_LE(once, 2 * kMaxMisses + 2 * 64);
    EXPECT_GT(count(0), once + kMaxMisses) << "where nothing is said of searches";
    EXPECT_GT(count(2), 0);
}

TEST_F(ReleasesAhead, FindAPlaceInTheNextSearchThatDidNotSuitInTheLast)
{
    World world(scene, mesh);
    std::vector<Eigen::Vector3d> found;
    for (const int count : {1, 3})
    {
        Threads threads(count);
        Releases releases(world, world.height, threads);
        ReleaseQuery query = queryAhead(64, false);
        query.givesUp = true;
        query.search = 1;
        EXPECT_FALSE(releases.next(query));
        query = queryAhead(64, true);
        query.givesUp = true;
        query.search = 2;
        const auto next = releases.next(query);
        ASSERT_TRUE(next);
        found.push_back(next->place);
    }
    EXPECT_EQ(found[0], found[1]) << "the first that is drawn, found out ahead or not";
}

TEST_F(ReleasesAhead, GiveUpAPlaceWhereNothingStays)
{
    World world(scene, mesh);
    for (const int count : {1, 2})
    {
        Threads threads(count);
        Releases releases(world, world.height, threads);
        ReleaseQuery query = queryAhead(16, true);
        query.prepare = [](Eigen::Vector3d& place, double, Footprint&) { return place.x() > 8; };
        const auto next = releases.next(query);
        ASSERT_TRUE(next);
        EXPECT_GT(next->place.x(), 8);
        query.prepare = [](Eigen::Vector3d&, double, Footprint&) { return false; };
        EXPECT_FALSE(releases.next(query));
    }
}

} // namespace
} // namespace frostfill
