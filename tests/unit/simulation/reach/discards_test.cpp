// SPDX-License-Identifier: MIT
#include "simulation/reach/discards.hpp"

#include "geometry/closest_point.hpp"
#include "support/discard_objects.hpp"
#include "support/paths.hpp"
#include "support/small_world.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

Scene sceneOf(const std::string& object, Motion motion, std::size_t spheres)
{
    Scene scene = presetScene(Preset::fast, object);
    scene.motion.mode = motion;
    scene.spheres.radius.reset();
    scene.spheres.count = spheres;
    scene.threads = 1;
    return scene;
}

/// Watches a run by brute force: every sphere that runs or comes to rest, against everything that
/// was called discarded before.
class Watch
{
public:
    Watch(const Scene& scene, const TriangleMesh& mesh) : simulation_(scene, mesh), mesh_(mesh) {}

    void run()
    {
        bool goesOn = true;
        while (goesOn)
        {
            goesOn = simulation_.step();
            look(); // at what has moved, beside what was called discarded after the step before
            capture();
            look();
        }
    }
    [[nodiscard]] const Snapshot& last() const { return snapshot_; }
    /// The nearest that a sphere has come to something discarded [smallest radius].
    double nearest = 1e300;
    std::size_t looks = 0;

private:
    void capture()
    {
        simulation_.capture(snapshot_);
        discarded_.clear();
        rested_.clear();
        for (std::size_t id = 0; id < snapshot_.states.size(); ++id)
        {
            if (snapshot_.states[id] != SphereState::running)
            {
                rested_.push_back(simulation_.sphere(id).centre);
            }
            if (snapshot_.states[id] == SphereState::discarded)
            {
                discarded_.push_back(simulation_.sphere(id));
            }
        }
    }
    void look()
    {
        for (std::size_t id = 0; id < simulation_.sphereCount(); ++id)
        {
            const SphereRecord sphere = simulation_.sphere(id);
            const bool isNew = id >= snapshot_.states.size();
            const bool ran = isNew || snapshot_.states[id] == SphereState::running;
            // One at rest may have taken over the number of one that was withdrawn.
            if (ran && std::find(rested_.begin(), rested_.end(), sphere.centre) == rested_.end())
            {
                lookAround(sphere);
            }
        }
    }
    void lookAround(const SphereRecord& sphere)
    {
        double gap = 1e300;
        for (const SphereRecord& other : discarded_)
        {
            ++looks;
            gap = std::min(gap, (other.centre - sphere.centre).norm() - other.radius);
        }
        const std::size_t stride = 1 + mesh_.triangles.size() / 3000; // of scans only some
        for (std::size_t t = 0; t < snapshot_.polygons.size(); t += stride)
        {
            if (snapshot_.polygons[t] == PolygonState::discarded)
            {
                const auto& [a, b, c] = mesh_.triangles[t];
                const auto near = closestPointOnTriangle(sphere.centre, mesh_.vertices[a],
                                                         mesh_.vertices[b], mesh_.vertices[c]);
                gap = std::min(gap, (near.point - sphere.centre).norm());
            }
        }
        nearest = std::min(nearest, (gap - sphere.radius) / simulation_.smallestRadius());
    }

    Simulation simulation_;
    const TriangleMesh& mesh_;
    Snapshot snapshot_;
    std::vector<SphereRecord> discarded_; ///< in it
    std::vector<Eigen::Vector3d> rested_; ///< frozen or discarded in it
};

class Discarded : public ::testing::TestWithParam<std::tuple<std::string, Motion>>
{
};

TEST_P(Discarded, IsNeverTouchedAgain)
{
    const auto& [name, motion] = GetParam();
    const auto mesh = discardObject(name, testing_support::sharedMeshes().string());
    if (!mesh)
    {
        GTEST_SKIP() << testing_support::whyMissing(
            discardObjectFile(name, testing_support::sharedMeshes()));
    }
    for (const bool untilFull : {false, true})
    {
        Scene scene = sceneOf(name, motion, 70);
        scene.spheres.untilFull = untilFull;
        Watch watch(scene, *mesh);
        watch.run();
        EXPECT_GE(watch.nearest, 0.99 * kDiscardGap);
        EXPECT_GT(watch.looks, 100U);
        const auto spheres = static_cast<double>(watch.last().states.size());
        EXPECT_GT(static_cast<double>(watch.last().discarded), spheres * (untilFull ? 0.7 : 0.25));
    }
}

std::string nameOf(const ::testing::TestParamInfo<std::tuple<std::string, Motion>>& info)
{
    const std::array<std::string, 3> motions = {"_fall", "_skip", "_descend"};
    return std::get<0>(info.param) + motions.at(static_cast<std::size_t>(std::get<1>(info.param)));
}

INSTANTIATE_TEST_SUITE_P(EveryObject, Discarded,
                         ::testing::Combine(::testing::ValuesIn(discardObjectNames()),
                                            ::testing::Values(Motion::fall, Motion::skip,
                                                              Motion::descend)),
                         nameOf);

TEST(Discards, AreNeverTouchedAgainBySpheresOfSeveralSizes)
{
    const TriangleMesh mesh = builtInMesh("cube");
    for (const Motion motion : {Motion::skip, Motion::descend})
    {
        Scene scene = sceneOf("cube", motion, 200);
        scene.spheres.radius = Radii(0.09, 0.16);
        Watch watch(scene, mesh);
        watch.run();
        EXPECT_GE(watch.nearest, 0.99 * kDiscardGap);
        EXPECT_GT(watch.last().discarded, 14U);
        EXPECT_GT(watch.last().discardedPolygons, 70U);
    }
}

TEST(Discards, AreMostOfWhatAPileCovers)
{
    for (const char* object : {"torus", "cube"})
    {
        const TriangleMesh mesh = builtInMesh(object);
        Simulation simulation(sceneOf(object, Motion::skip, 1000), mesh);
        while (simulation.step())
        {
        }
        const SetRecord& last = simulation.sets().back();
        EXPECT_GE(static_cast<double>(last.discarded), 0.8 * 1000);
        EXPECT_GE(static_cast<double>(last.discardedPolygons),
                  0.6 * static_cast<double>(mesh.triangles.size()));
    }
}

/// What is discarded after each step of a run, of which only every so many are looked at.
std::vector<std::pair<std::vector<SphereState>, std::vector<PolygonState>>>
statesOf(const std::string& object, Motion motion, int threads, int stride, bool inspects)
{
    Scene scene = sceneOf(object, motion, 300);
    scene.threads = threads;
    Simulation simulation(scene, builtInMesh(object));
    if (inspects)
    {
        (void)simulation.inspectReach(std::size_t{1} << 28);
    }
    Snapshot snapshot;
    std::vector<std::pair<std::vector<SphereState>, std::vector<PolygonState>>> states;
    for (int step = 1; simulation.step(); ++step)
    {
        if (step % stride == 0)
        {
            simulation.capture(snapshot);
        }
        states.emplace_back(snapshot.states, snapshot.polygons);
    }
    simulation.capture(snapshot);
    states.emplace_back(snapshot.states, snapshot.polygons);
    return states;
}

TEST(Discards, AreTheSameHoweverOftenSomebodyAsksWithAnyNumberOfThreads)
{
    constexpr int kStride = 7;
    for (const Motion motion : {Motion::skip, Motion::descend})
    {
        const auto often = statesOf("torus", motion, 1, 1, false);
        for (const int threads : {1, 3})
        {
            const auto seldom = statesOf("torus", motion, threads, kStride, threads == 3);
            ASSERT_EQ(seldom.size(), often.size());
            for (std::size_t k = kStride; k < often.size(); k += kStride)
            {
                EXPECT_EQ(seldom[k - 1], often[k - 1]) << k;
            }
            EXPECT_EQ(seldom.back(), often.back());
        }
    }
}

// Before, it may have to be touched again.
TEST(Discards, AreNoneBeforeAMovementIsOver)
{
    Scene scene = sceneOf("torus", Motion::skip, 60);
    scene.move.tilt = 20;
    Simulation simulation(scene, builtInMesh("torus"));
    Snapshot snapshot;
    while (simulation.step())
    {
        simulation.capture(snapshot);
        EXPECT_EQ(snapshot.discarded + snapshot.discardedPolygons, 0U);
    }
    simulation.capture(snapshot);
    EXPECT_GT(snapshot.discarded, 10U);
    EXPECT_GT(snapshot.discardedPolygons, 100U);
}

// A picture jumps in which the last sphere's rest decides about much of the object.
TEST(Discards, LeavesFewPolygonsToTheEndOfARunUntilFull)
{
    Scene scene = sceneOf("human", Motion::fall, 300);
    scene.spheres.untilFull = true;
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

    std::unique_ptr<World> world_;
    std::vector<std::uint32_t> ids_;
};

TEST_F(FullBox, OnlyTheNeighboursOfTheHoleAreKept)
{
    Discards discards(*world_);
    world_->clock.finished = true;
    discards.update();
    EXPECT_EQ(world_->spheres.discardedCount(), ids_.size() - 12);
    EXPECT_EQ(world_->discardedPolygons, world_->polygons.size());
    for (const std::uint32_t id : ids_)
    {
        const bool beside = world_->spheres.position(id).norm() < 2.1;
        EXPECT_EQ(world_->spheres.state(id), beside ? SphereState::frozen : SphereState::discarded);
    }
}

TEST_F(FullBox, NothingIsDiscardedWithoutTheRule)
{
    world_->scene.discard.rule = DiscardRule::none;
    Discards discards(*world_);
    discards.update();
    EXPECT_EQ(world_->spheres.discardedCount() + world_->discardedPolygons, 0U);
}

} // namespace
} // namespace frostfill
