// SPDX-License-Identifier: MIT
#include "simulation/engine/make_engine.hpp"
#include "simulation/engine/tolerances.hpp"
#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace frostfill
{
namespace
{

struct Case
{
    Motion motion;
    bool torus;
};

class FastEngines : public ::testing::TestWithParam<Case>
{
protected:
    [[nodiscard]] Scene scene(std::uint64_t seed) const
    {
        Scene result = presetScene(Preset::fast, "torus");
        result.motion.mode = GetParam().motion;
        result.spheres.count.reset();
        result.spheres.radius = GetParam().torus ? 0.11 : 0.15;
        result.seed = seed;
        return result;
    }
    [[nodiscard]] TriangleMesh mesh() const
    {
        return GetParam().torus ? shapes::torus() : shapes::box({-1, -1, -1}, {1, 1, 1}, 8);
    }
};

TEST_P(FastEngines, FillUntilFullWithoutOverlapAndWithoutASphereInTheAir)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
        Simulation simulation(scene(seed), mesh());
        while (simulation.step())
        {
            ASSERT_LT(simulation.steps(), 200000u) << "seed " << seed << " does not end";
        }
        EXPECT_TRUE(simulation.full());
        EXPECT_EQ(simulation.restingCount(), simulation.sphereCount());
        const QualityReport quality = simulation.quality();
        EXPECT_LT(quality.maxOverlap, 1e-9) << "seed " << seed;
        EXPECT_LT(quality.maxWallOverlap, 1e-7) << "seed " << seed;
        EXPECT_EQ(quality.unsupported, 0u) << "seed " << seed;
        EXPECT_EQ(quality.centresOutside, 0u) << "seed " << seed;
        EXPECT_EQ(quality.notFinite, 0u) << "seed " << seed;
        EXPECT_GT(quality.sphereVolume / quality.meshVolume, 0.4) << "seed " << seed;
    }
}

TEST_P(FastEngines, EqualScenesGiveEqualBits)
{
    const auto hash = [this]
    {
        Simulation simulation(scene(7), mesh());
        while (simulation.step())
        {
        }
        return simulation.stateHash();
    };
    EXPECT_EQ(hash(), hash());
}

TEST_P(FastEngines, GiveTheSameBitsWithAndWithoutExactDiscards)
{
    const auto run = [this](DiscardRule rule)
    {
        Scene chosen = scene(5);
        chosen.discard.rule = rule;
        auto simulation = std::make_unique<Simulation>(chosen, mesh());
        while (simulation->step())
        {
        }
        return simulation;
    };
    const auto with = run(DiscardRule::exact);
    const auto without = run(DiscardRule::none);
    EXPECT_EQ(with->stateHash(), without->stateHash());
    EXPECT_GT(with->sets().back().discarded, with->sphereCount() / 8);
    EXPECT_EQ(without->sets().back().discarded, 0u);
}

TEST_P(FastEngines, GiveTheSameBitsWithAnyNumberOfThreads)
{
    for (const bool bySet : {false, true})
    {
        const auto run = [&](int threads)
        {
            Scene chosen = scene(3);
            chosen.threads = threads;
            chosen.spheres.groupSize = 50; // enough at once to be shared out
            chosen.freezing.rule = bySet && chosen.motion.mode != Motion::descend
                                       ? FreezingRule::bySet
                                       : FreezingRule::oneByOne;
            auto simulation = std::make_unique<Simulation>(chosen, mesh());
            while (simulation->step())
            {
            }
            return simulation;
        };
        const auto one = run(1);
        for (const int threads : {2, 3, 8})
        {
            SCOPED_TRACE(threads);
            const auto several = run(threads);
            EXPECT_EQ(several->stateHash(), one->stateHash());
            EXPECT_EQ(several->steps(), one->steps());
            EXPECT_EQ(several->operations(), one->operations());
            EXPECT_EQ(several->quality().energyGain, one->quality().energyGain);
        }
    }
}

TEST_P(FastEngines, StopAtTheCount)
{
    Scene some = scene(1);
    some.spheres.count = 50;
    Simulation simulation(some, mesh());
    while (simulation.step())
    {
    }
    EXPECT_EQ(simulation.sphereCount(), 50u);
    EXPECT_FALSE(simulation.full());
}

TEST_P(FastEngines, IncrementalCaptureEqualsAFreshOne)
{
    Simulation simulation(scene(2), mesh());
    Snapshot kept;
    bool more = true;
    while (more)
    {
        for (int k = 0; k < 9 && more; ++k)
        {
            more = simulation.step();
        }
        simulation.capture(kept);
        Snapshot fresh;
        simulation.capture(fresh);
        ASSERT_EQ(kept.centres, fresh.centres);
        ASSERT_EQ(kept.states, fresh.states);
        ASSERT_EQ(kept.groups, fresh.groups);
    }
}

std::string nameOf(const ::testing::TestParamInfo<Case>& info)
{
    constexpr std::array<const char*, 3> kNames = {"Fall", "Skip", "Descend"};
    return std::string(kNames[static_cast<std::size_t>(info.param.motion)]) +
           (info.param.torus ? "Torus" : "Cube");
}

INSTANTIATE_TEST_SUITE_P(EveryMotion, FastEngines,
                         ::testing::Values(Case{Motion::fall, true}, Case{Motion::fall, false},
                                           Case{Motion::skip, true}, Case{Motion::skip, false},
                                           Case{Motion::descend, true},
                                           Case{Motion::descend, false}),
                         nameOf);

// Its squares are bent by a few millionths: less than a contact tells apart, more than a sphere
// that slides over them may ignore.
TEST(FastEngine, LeavesNoSphereInTheAirOnAMeshInSinglePrecision)
{
    TriangleMesh mesh = shapes::torus();
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = vertex.cast<float>().cast<double>();
    }
    Scene scene = presetScene(Preset::fast, "torus");
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
        scene.seed = seed;
        Simulation simulation(scene, mesh);
        while (simulation.step())
        {
        }
        EXPECT_EQ(simulation.quality().unsupported, 0u) << "seed " << seed;
        EXPECT_LT(simulation.quality().maxWallOverlap, 1e-7) << "seed " << seed;
    }
}

TEST(FastEngine, RecordsTheTimeThatItsSolverTakes)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = 60;
    Simulation simulation(scene, shapes::torus());
    while (simulation.step())
    {
    }
    ASSERT_FALSE(simulation.sets().empty());
    const SetRecord& set = simulation.sets().front();
    EXPECT_GT(set.meanSphereSphereMs, 0);
    // No more than a twentieth of the steps take longer, so it is at most 20 means.
    EXPECT_GT(set.p95SphereSphereMs, 0);
    EXPECT_LE(set.p95SphereSphereMs, 20 * set.meanSphereSphereMs + 1e-6);
    EXPECT_LE(set.meanSphereSphereMs * static_cast<double>(set.steps),
              1000 * simulation.times()[Stage::sphereSphere] + 1e-6);
}

// So that pictures fall on the steps that were asked for.
TEST(FastEngine, DividesAStepThatIsTooLongIntoTheFewestEqualParts)
{
    for (const double asked : {0.1, 0.33, 0.34, 1.0, 2.5}) // in units of the smallest sphere
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.radius = Radii(0.05, 0.1);
        scene.motion.dt = asked * std::sqrt(0.05 / scene.motion.gravity);
        World world(scene, shapes::torus());
        const auto engine = makeEngine(world);
        const double step = world.clock.dt * world.frame.time;
        const double parts = *scene.motion.dt / step;
        EXPECT_EQ(std::lround(parts), std::lround(std::ceil(asked / kSkipStep - 1e-9))) << asked;
        EXPECT_NEAR(parts, std::round(parts), 1e-12) << asked;
    }
}

// Of whatever engine, and in whatever search it is.
TEST(Simulation, IsNotFullForASearchThatWasStopped)
{
    for (const auto& [preset, motion] : {std::pair{Preset::paper, Motion::fall},
                                         {Preset::fast, Motion::fall},
                                         {Preset::fast, Motion::skip},
                                         {Preset::fast, Motion::descend},
                                         {Preset::fast, Motion::granular}})
    {
        Scene scene = presetScene(preset, "torus");
        scene.motion.mode = motion;
        scene.rest.mode = motion == Motion::granular ? Rest::joint : Rest::each;
        scene.spheres.radius = 0.17;
        scene.spheres.count.reset();
        Simulation whole(scene, shapes::torus());
        while (whole.step())
        {
        }
        Simulation stopped(scene, shapes::torus());
        int asked = 0;
        int limit = 0;
        stopped.stopWhen([&] { return ++asked > limit; });
        for (int step = 0; stopped.step(); ++step)
        {
            asked = 0;
            limit = 1 + step * 37 % 400;
        }
        EXPECT_TRUE(stopped.full());
        EXPECT_GT(static_cast<double>(stopped.sphereCount()),
                  0.9 * static_cast<double>(whole.sphereCount()))
            << static_cast<int>(preset) << " " << static_cast<int>(motion);
    }
}

// An engine of its own may be given more than its scene counts.
TEST(Engines, AddNoneToMoreSpheresThanTheCount)
{
    for (const auto& [preset, motion] : {std::pair{Preset::paper, Motion::fall},
                                         {Preset::fast, Motion::fall},
                                         {Preset::fast, Motion::skip},
                                         {Preset::fast, Motion::descend},
                                         {Preset::fast, Motion::granular}})
    {
        Scene scene = presetScene(preset, "cube");
        scene.motion.mode = motion;
        scene.rest.mode = motion == Motion::granular ? Rest::joint : Rest::each;
        scene.spheres.radius = 0.2;
        scene.spheres.count = 2;
        World world(scene, builtInMesh("cube"));
        const auto engine = makeEngine(world);
        engine->releaseAt(std::vector<PlacedSphere>{{{0, 0, 0}}, {{2.5, 0, 0}}, {{-2.5, 0, 0}}});
        for (int step = 0; engine->step() && world.spheres.size() < 10;)
        {
            ASSERT_LT(++step, 100'000);
        }
        EXPECT_EQ(world.spheres.size(), 3U)
            << static_cast<int>(preset) << " " << static_cast<int>(motion);
        EXPECT_TRUE(world.clock.finished);
        EXPECT_FALSE(world.clock.full);
    }
}

TEST(Simulation, EndsAStepEarlyWhenItIsToStopAndGoesOnAfterwards)
{
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.motion.mode = motion;
        scene.spheres.count = 60;
        Simulation simulation(scene, shapes::torus());
        bool stop = true;
        simulation.stopWhen([&] { return stop; });
        EXPECT_TRUE(simulation.step());
        EXPECT_EQ(simulation.sphereCount(), 0u);
        EXPECT_FALSE(simulation.finished());
        stop = false;
        while (simulation.step())
        {
        }
        EXPECT_EQ(simulation.restingCount(), 60u);
        EXPECT_FALSE(simulation.full());
    }
}

} // namespace
} // namespace frostfill
