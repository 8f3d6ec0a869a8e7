// SPDX-License-Identifier: MIT
// Draws of a batch that are computed ahead, on several threads: the answer is that of one thread.
#include "base/random.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/release/releases.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace frostfill
{
namespace
{

/// Forty spheres at rest in a box, where they fall from places by chance.
class WhatAPathHasSeen : public ::testing::Test
{
protected:
    explicit WhatAPathHasSeen() : world(smallWorld(shapes::box({-6, -10, -6}, {6, 10, 6}, 3)))
    {
        for (int k = 0; k < 40; ++k)
        {
            addResting(*world, pathFrom(chance()).first);
        }
    }

    /// By chance, high up.
    Eigen::Vector3d chance()
    {
        const auto coordinate = [&] { return 5 * (2 * uniformRandom(11, 0, draws_++) - 1); };
        const double x = coordinate();
        return {x, 8.5, coordinate()};
    }
    std::pair<Eigen::Vector3d, bool> pathFrom(Eigen::Vector3d p,
                                              Eigen::AlignedBox3d* seen = nullptr)
    {
        NeighbourList around;
        const bool rests =
            DropAndRoll(*world).settle(p, 1, around, std::numeric_limits<double>::infinity(), seen);
        return {p, rests};
    }

    std::unique_ptr<World> world;

private:
    std::uint64_t draws_ = 0;
};

// The oracle is the path itself, found again: a further sphere outside of the box changes no bit of
// it.
TEST_F(WhatAPathHasSeen, HoldsEverySphereThatChangesThePath)
{
    int met = 0;
    int changed = 0;
    constexpr int kTries = 400;
    for (int k = 0; k < kTries; ++k)
    {
        const Eigen::Vector3d from = chance();
        Eigen::AlignedBox3d seen;
        const auto before = pathFrom(from, &seen);
        Eigen::Vector3d newcomer = pathFrom(chance()).first;
        if (k % 2 == 0)
        {
            newcomer.y() = 6 - k % 7; // in the air, where paths fall
        }
        const std::uint32_t id = addResting(*world, newcomer);
        const bool differs = pathFrom(from) != before;
        world->spheres.wake(id);
        world->spheres.withdraw(id);
        world->spheres.closeRanks();
        const bool meets = seen.contains(newcomer);
        ASSERT_TRUE(meets || !differs) << k;
        met += meets ? 1 : 0;
        changed += differs ? 1 : 0;
    }
    EXPECT_GT(changed, kTries / 20);
    EXPECT_LT(met, kTries / 2) << "a box that holds everything is no use";
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

class ComputingAhead : public ::testing::TestWithParam<Rain>
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

// One thread computes nothing ahead: it is the oracle.
TEST_P(ComputingAhead, ChangesNoBit)
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
    Objects, ComputingAhead,
    ::testing::Values(Rain{"BoxDescend", shapes::box({-1, -1, -1}, {1, 1, 1}, 3), Motion::descend,
                           0.12},
                      Rain{"BoxSkip", shapes::box({-1, -1, -1}, {1, 1, 1}, 3), Motion::skip, 0.12},
                      Rain{"TorusDescend", shapes::torus(), Motion::descend, 0.12},
                      Rain{"TorusFall", shapes::torus(), Motion::fall, 0.12},
                      Rain{"MixedDescend", shapes::torus(), Motion::descend, 0.08},
                      Rain{"MixedSkip", shapes::torus(), Motion::skip, 0.08}),
    [](const auto& about) { return about.param.name; });

/// What a release rule finds when every place is taken at once, and how much of it was computed
/// ahead.
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
    query.prepare = [&](Eigen::Vector3d& place, double radius, Eigen::AlignedBox3d& seen)
    {
        ++prepared;
        addSeen(seen, place, radius);
        addSeen(seen, {place.x(), -9, place.z()}, radius);
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
        EXPECT_FALSE(releases.next(query));
        query = queryAhead(64, true);
        query.givesUp = true;
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
        query.prepare = [](Eigen::Vector3d& place, double, Eigen::AlignedBox3d&)
        { return place.x() > 8; };
        const auto next = releases.next(query);
        ASSERT_TRUE(next);
        EXPECT_GT(next->place.x(), 8);
        query.prepare = [](Eigen::Vector3d&, double, Eigen::AlignedBox3d&) { return false; };
        EXPECT_FALSE(releases.next(query));
    }
}

} // namespace
} // namespace frostfill
