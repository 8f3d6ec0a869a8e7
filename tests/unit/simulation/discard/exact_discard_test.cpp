// SPDX-License-Identifier: MIT
#include "simulation/discard/exact_discard.hpp"

#include "simulation/contact/neighbour_list.hpp"
#include "support/discard_objects.hpp"
#include "support/paths.hpp"
#include "support/small_world.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

struct Outcome
{
    std::string hash;
    std::size_t spheres = 0;
    std::size_t dropped = 0;
    std::size_t droppedPolygons = 0;
};

Outcome runScene(const Scene& scene, const TriangleMesh& mesh)
{
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    const SetRecord& last = simulation.sets().back();
    return {simulation.stateHash(), simulation.sphereCount(), last.discarded,
            last.discardedPolygons};
}

Scene sceneOf(const std::string& object, Motion motion, std::uint64_t seed, std::size_t spheres)
{
    Scene scene = presetScene(Preset::fast, object);
    scene.motion.mode = motion;
    scene.seed = seed;
    scene.spheres.radius.reset();
    scene.spheres.count = spheres;
    scene.threads = 1;
    return scene;
}

class ExactDiscards : public ::testing::TestWithParam<std::tuple<std::string, Motion>>
{
};

// With many seeds and spheres: tests/benchmark/exact_discard.cpp.
TEST_P(ExactDiscards, ChangeNoBitUntilFull)
{
    const auto& [name, motion] = GetParam();
    const auto mesh = discardObject(name, testing_support::sharedMeshes().string());
    if (!mesh)
    {
        GTEST_SKIP() << testing_support::whyMissing(
            discardObjectFile(name, testing_support::sharedMeshes()));
    }
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
        Scene scene = sceneOf(name, motion, seed, 60);
        scene.spheres.untilFull = true;
        scene.discard.rule = DiscardRule::none;
        const Outcome without = runScene(scene, *mesh);
        scene.discard.rule = DiscardRule::exact;
        const Outcome with = runScene(scene, *mesh);
        EXPECT_EQ(with.hash, without.hash) << "seed " << seed;
        EXPECT_EQ(without.dropped, 0u);
        EXPECT_GT(with.dropped, with.spheres / 2);
        if (seed == 1)
        {
            scene.threads = 2;
            EXPECT_EQ(runScene(scene, *mesh).hash, with.hash);
        }
    }
}

std::string nameOf(const ::testing::TestParamInfo<std::tuple<std::string, Motion>>& info)
{
    return std::get<0>(info.param) + (std::get<1>(info.param) == Motion::fall ? "_fall" : "_skip");
}

INSTANTIATE_TEST_SUITE_P(EveryObject, ExactDiscards,
                         ::testing::Combine(::testing::ValuesIn(discardObjectNames()),
                                            ::testing::Values(Motion::fall, Motion::skip)),
                         nameOf);

// Counted where a further sphere still fits on top of the pile, not in an object that is full.
TEST(ExactDiscard, DropsMostOfWhatAPileCovers)
{
    for (const char* object : {"torus", "cube"})
    {
        Scene scene = sceneOf(object, Motion::skip, 1, 1000);
        scene.discard.rule = DiscardRule::exact;
        const TriangleMesh mesh = builtInMesh(object);
        const Outcome run = runScene(scene, mesh);
        EXPECT_GE(static_cast<double>(run.dropped), 0.8 * static_cast<double>(run.spheres));
        EXPECT_GE(static_cast<double>(run.droppedPolygons),
                  0.6 * static_cast<double>(mesh.triangles.size()));
    }
}

// What is discarded, and when: the history that pictures and tables show.
TEST(ExactDiscard, DropsTheSameAtTheSameTimeWithAnyNumberOfThreads)
{
    for (const Motion motion : {Motion::skip, Motion::descend})
    {
        for (const double smallest : {1.0, 0.3})
        {
            const auto history = [&](int threads)
            {
                Scene scene = sceneOf("cube", motion, 1, 1);
                scene.spheres.count.reset();
                scene.spheres.radius = Radii(0.09 * smallest, 0.09);
                scene.threads = threads;
                Simulation simulation(scene, builtInMesh("cube"));
                std::vector<std::size_t> numbers;
                std::string states;
                while (simulation.step())
                {
                }
                for (const SetRecord& set : simulation.sets())
                {
                    numbers.insert(numbers.end(),
                                   {set.frozen, set.discarded, set.discardedPolygons});
                }
                for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
                {
                    states += std::to_string(static_cast<int>(simulation.sphere(id).state));
                }
                return std::pair(numbers, states);
            };
            const auto one = history(1);
            EXPECT_GT(one.first.size(), 30u);
            for (const int threads : {2, 3, 8})
            {
                EXPECT_EQ(history(threads), one) << threads;
            }
        }
    }
}

// A picture jumps in which the last sphere's rest decides about much of the object.
TEST(ExactDiscard, LeavesFewPolygonsToTheEndOfARunUntilFull)
{
    Scene scene = sceneOf("human", Motion::fall, 1, 300);
    scene.spheres.untilFull = true;
    scene.discard.rule = DiscardRule::exact;
    const TriangleMesh mesh = builtInMesh("human");
    Simulation simulation(scene, mesh);
    Snapshot snapshot;
    std::size_t before = 0;
    while (simulation.step())
    {
        before = snapshot.discardedPolygons;
        simulation.capture(snapshot);
    }
    simulation.capture(snapshot);
    EXPECT_LT(snapshot.discardedPolygons - before, mesh.triangles.size() / 15);
}

/// A box full of a face-centred cubic packing that nothing more fits into, but for a hole where one
/// sphere is missing.
class FullBox : public ::testing::Test
{
protected:
    FullBox() : world_(smallWorld(shapes::box({-7, -7, -7}, {7, 7, 7}, 4)))
    {
        constexpr double kEdge = 2.8284272; // of the cell, spheres just apart
        for (int i = -4; i <= 4; ++i)
        {
            for (int j = -4; j <= 4; ++j)
            {
                for (int k = -4; k <= 4; ++k)
                {
                    const Eigen::Vector3d p = kEdge / 2 * Eigen::Vector3d(i, j, k);
                    if ((i + j + k) % 2 == 0 && (i != 0 || j != 0 || k != 0))
                    {
                        ids_.push_back(addResting(*world_, p));
                    }
                }
            }
        }
    }

    /// All but the hole's neighbours are dropped, as a sphere runs in the hole.
    void dropAroundTheHole()
    {
        rest();
        EXPECT_FALSE(discard_.afterStep());
        discard_.finish(false);
        ASSERT_GT(world_->spheres.discardedCount(), ids_.size() / 2);
    }

    void rest()
    {
        for (const std::uint32_t id : ids_)
        {
            discard_.addResting(id);
        }
    }

    std::unique_ptr<World> world_;
    std::vector<std::uint32_t> ids_;
    Threads threads_{2};
    ExactDiscard discard_{*world_, threads_};
    /// Where the sphere is that runs in the hole.
    Eigen::Vector3d& runnerInTheHole()
    {
        return world_->spheres.running().position[world_->spheres.row(inTheHole_)];
    }
    std::uint32_t inTheHole_ = world_->spheres.add({0, 0, 0}, 1, 1);
};

TEST_F(FullBox, OnlyTheNeighboursOfTheHoleAreKept)
{
    dropAroundTheHole();
    EXPECT_EQ(world_->counts.restoredDiscards, 0u);
    EXPECT_EQ(world_->spheres.discardedCount(), ids_.size() - 12);
    EXPECT_EQ(world_->discardedPolygons, world_->polygons.size());
    for (const std::uint32_t id : ids_)
    {
        const bool beside = world_->spheres.position(id).norm() < 2.1;
        EXPECT_EQ(world_->spheres.state(id), beside ? SphereState::frozen : SphereState::discarded);
    }
}

// A running sphere is put where the map says that none can be.
TEST_F(FullBox, EverythingComesBackWhenASphereIsWhereNoneCanBe)
{
    dropAroundTheHole();

    const Eigen::Vector3d place = world_->spheres.position(ids_.front()) * 0.95;
    world_->spheres.add(place, 1, 1);
    NeighbourList around;
    around.ensure(*world_, place, 1, 0);
    EXPECT_EQ(around.spheres().size(), 0u) << "the neighbours are dropped";
    EXPECT_TRUE(discard_.afterStep());
    EXPECT_GT(world_->counts.restoredDiscards, 0u);
    EXPECT_EQ(world_->spheres.discardedCount(), 0u);
    EXPECT_EQ(world_->discardedPolygons, 0u);
    EXPECT_EQ(std::count(world_->polygons.begin(), world_->polygons.end(), PolygonState::discarded),
              0);
    around.invalidate();
    around.ensure(*world_, place, 1, 0);
    EXPECT_GT(around.spheres().size(), 0u);
    // And it carries on.
    (void)discard_.afterStep();
    discard_.finish(false);
    EXPECT_LE(world_->counts.restoredDiscards, 2u);
}

// An overlap that the wider margins allow for: the rule goes on with these.
TEST_F(FullBox, DropsAgainWithWiderMarginsAfterASmallOverlap)
{
    dropAroundTheHole();
    // Beside the hole, into a cube that only several spheres cover together.
    for (double away = 0.1; world_->counts.restoredDiscards == 0 && away < 1; away += 0.1)
    {
        for (int side = 0; side < 6 && world_->counts.restoredDiscards == 0; ++side)
        {
            runnerInTheHole().setZero();
            runnerInTheHole()[side / 2] = side % 2 == 0 ? away : -away;
            const bool cameBack = discard_.afterStep();
            EXPECT_EQ(cameBack, world_->counts.restoredDiscards > 0);
        }
    }
    ASSERT_EQ(world_->counts.restoredDiscards, 1u);
    EXPECT_EQ(world_->spheres.discardedCount(), 0u);
    runnerInTheHole().setZero();
    EXPECT_FALSE(discard_.afterStep());
    discard_.finish(false);
    EXPECT_EQ(world_->counts.restoredDiscards, 1u);
    EXPECT_GT(world_->spheres.discardedCount(), ids_.size() / 3);
}

TEST_F(FullBox, NothingIsDroppedTwiceOrLostWhenASphereIsRenumbered)
{
    rest();
    // The last one takes over the id of a sphere that is withdrawn.
    discard_.addResting(addResting(*world_, {0, 0, 0}));
    discard_.renumber(world_->spheres.withdraw(inTheHole_), inTheHole_);
    world_->spheres.closeRanks();
    EXPECT_FALSE(discard_.afterStep());
    discard_.finish(false);
    EXPECT_EQ(world_->counts.restoredDiscards, 0u);
    EXPECT_EQ(world_->spheres.discardedCount(), ids_.size() + 1) << "nothing fits in any more";
    for (std::size_t id = 0; id < world_->spheres.size(); ++id)
    {
        EXPECT_EQ(world_->spheres.state(id), SphereState::discarded);
    }
}

} // namespace
} // namespace frostfill
