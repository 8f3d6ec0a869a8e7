// SPDX-License-Identifier: MIT
// The stress matrix and the closed forms at a size that runs in seconds; scenes drawn at random,
// the seed of which a failure tells.

#include "base/random.hpp"
#include "oracle/motion.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "simulation/world/spheres.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kEnergyTolerance = 1e-9;

/// A scene whose every number is drawn from a seed.
Scene randomRun(std::uint64_t seed)
{
    auto draw = [&, k = std::uint64_t{0}](double low, double high) mutable
    { return low + (high - low) * uniformRandom(seed, 77, ++k); };
    Scene scene = presetScene(Preset::fast, "torus");
    scene.seed = seed;
    const double largest = draw(0.09, 0.16);
    scene.spheres.radius = Radii(largest / draw(1, 3), largest);
    scene.spheres.count = static_cast<std::uint64_t>(draw(5, 30));
    scene.spheres.groupSize = static_cast<std::uint32_t>(draw(1, 20));
    scene.spheres.groupsPerSet = static_cast<std::uint32_t>(draw(1, 4));
    scene.motion.mode = draw(0, 1) < 0.5 ? Motion::fall : Motion::skip;
    scene.motion.restitution = draw(0, 1);
    scene.motion.dt = std::pow(10, draw(-2.5, -1));
    scene.motion.gravity = std::pow(10, draw(-2, 3));
    scene.object.up = static_cast<Axis>(static_cast<int>(draw(0, 3)));
    return scene;
}

std::string runToItsEnd(const Scene& scene, const TriangleMesh& mesh, QualityReport& quality)
{
    World world(scene, mesh);
    const auto engine = makeEngine(world);
    while (engine->step())
    {
        for (const Eigen::Vector3d& p : world.spheres.running().position.all())
        {
            EXPECT_TRUE(p.allFinite());
        }
    }
    EXPECT_EQ(world.spheres.runningCount(), 0u);
    quality = examine(world);
    return hashState(world.spheres);
}

TEST(Stress, WhateverTheSceneNothingLeaksGainsEnergyOrDiffersFromOneRunToTheNext)
{
    const TriangleMesh mesh = builtInMesh("torus");
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Scene scene = randomRun(seed);
        QualityReport quality;
        scene.threads = 1;
        const std::string hash = runToItsEnd(scene, mesh, quality);
        EXPECT_EQ(quality.notFinite, 0u);
        EXPECT_EQ(quality.centresOutside, 0u);
        EXPECT_LE(quality.energyExcess, kEnergyTolerance);
        EXPECT_LE(quality.maxOverlap, 1e-7);
        EXPECT_LE(quality.maxWallOverlap, 1e-6);
        EXPECT_EQ(quality.unsupported, 0u);
        scene.threads = 2;
        EXPECT_EQ(runToItsEnd(scene, mesh, quality), hash);
        if (::testing::Test::HasFailure())
        {
            FAIL() << "seed " << seed << " in:\n" << sceneToToml(scene);
        }
    }
}

// In a narrow tube what freezes together is pushed about by its neighbours until the last moment.
TEST(Stress, CrowdsInNarrowTubesEndCarried)
{
    const TriangleMesh mesh = shapes::torus(24, 2.6, 160, 20);
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
    {
        for (const bool bySet : {false, true})
        {
            SCOPED_TRACE("seed " + std::to_string(seed) + (bySet ? ", by set" : ""));
            Scene scene = presetScene(Preset::fast, "torus");
            scene.seed = seed;
            scene.spheres.radius = 1;
            scene.spheres.count = 300;
            scene.spheres.groupSize = 1000;
            scene.freezing.rule = bySet ? FreezingRule::bySet : FreezingRule::oneByOne;
            QualityReport quality;
            scene.threads = 1;
            const std::string hash = runToItsEnd(scene, mesh, quality);
            EXPECT_EQ(quality.unsupported, 0u);
            EXPECT_EQ(quality.centresOutside, 0u);
            EXPECT_LE(quality.maxOverlap, 1e-7);
            scene.threads = 2;
            EXPECT_EQ(runToItsEnd(scene, mesh, quality), hash);
        }
    }
}

struct Released
{
    Released(Preset preset, const std::vector<PlacedSphere>& spheres)
        : world(scene(preset, spheres.size()), shapes::box({-8, -8, -8}, {8, 8, 8}, 8)),
          engine(makeEngine(world))
    {
        engine->releaseAt(spheres);
    }
    static Scene scene(Preset preset, std::size_t count)
    {
        Scene scene = presetScene(preset, "torus");
        scene.spheres.radius = 1;
        scene.spheres.count = count;
        return scene;
    }
    void run()
    {
        while (engine->step())
        {
        }
    }
    World world;
    std::unique_ptr<Engine> engine;
};

TEST(Stress, SpheresReleasedInOnePlaceEndApartAndGainNothing)
{
    for (const std::size_t count : {2u, 5u})
    {
        Released released(Preset::fast,
                          std::vector<PlacedSphere>(count, {Eigen::Vector3d(0.1, 1, 0.2), 1}));
        released.run();
        const QualityReport quality = examine(released.world);
        EXPECT_EQ(released.world.spheres.size(), count);
        EXPECT_LE(quality.maxOverlap, 1e-7);
        EXPECT_EQ(quality.centresOutside, 0u);
        EXPECT_LE(quality.energyExcess, kEnergyTolerance);
        EXPECT_EQ(quality.unsupported, 0u);
    }
}

TEST(Stress, ACrowdReleasedOverlappingIsTakenApartBeforeItMoves)
{
    std::vector<PlacedSphere> paired;
    for (std::uint64_t k = 0; k < 40; ++k)
    {
        Eigen::Vector3d p;
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] = 3 * (2 * uniformRandom(5, k, static_cast<std::uint64_t>(axis)) - 1);
        }
        paired.push_back({p, 1});
    }
    Released released(Preset::fast, paired);
    EXPECT_LE(examine(released.world).maxOverlap, 1e-6);
    released.run();
    const QualityReport quality = examine(released.world);
    EXPECT_LE(quality.energyExcess, kEnergyTolerance);
    EXPECT_LE(quality.maxOverlap, 1e-7);
    EXPECT_EQ(quality.unsupported, 0u);
}

TEST(Stress, CentresOnOrBeyondTheWallAreRefused)
{
    for (const Preset preset : {Preset::fast, Preset::paper})
    {
        for (const Eigen::Vector3d& place :
             {Eigen::Vector3d(8, 0.3, 0.2), Eigen::Vector3d(8, 8, 0.2), Eigen::Vector3d(8, 8, 8),
              Eigen::Vector3d(0, 11, 0), Eigen::Vector3d(0, std::nan(""), 0)})
        {
            test::expectError(
                ErrorCode::badData,
                [&] {
                    Released(preset, {{place, 1}});
                },
                "inside");
        }
    }
}

// Relative to the fall through the object.
TEST(Stress, EnergyGainOfExplicitEulerIsMeasuredExactly)
{
    Scene scene = Released::scene(Preset::paper, 1);
    scene.motion.gravity = 1;
    scene.motion.dt = 0.01;
    World world(scene, shapes::box({-8, -8, -8}, {8, 8, 8}, 8));
    const auto engine = makeEngine(world);
    const PlacedSphere one{{0, 6, 0}, 1};
    engine->releaseAt({&one, 1});
    for (int step = 0; step < 100; ++step)
    {
        engine->step();
    }
    EXPECT_NEAR(world.counts.energy.largestGain(), oracle::eulerGain(0.01) / 16, 1e-15);
    EXPECT_NEAR(world.counts.energy.excess(), 100 * oracle::eulerGain(0.01) / 16, 1e-13);
}

// A floor that gives back more than it takes; relative to the fall through the object.
TEST(Stress, EnergyGainOfABounceThatIsTooLivelyIsMeasured)
{
    Scene scene = Released::scene(Preset::fast, 1);
    scene.motion.restitution = 1.2;
    scene.motion.dt = 1e-3 * std::sqrt(1 / scene.motion.gravity);
    World world(scene, shapes::box({-8, -8, -8}, {8, 8, 8}, 8));
    const auto engine = makeEngine(world);
    const PlacedSphere one{{0, -5, 0}, 1};
    engine->releaseAt({&one, 1});
    while (world.spheres.velocity(0).y() <= 0)
    {
        ASSERT_TRUE(engine->step());
    }
    const double gain = (oracle::bounceApex(2, 1.2) - 2) / 16;
    EXPECT_NEAR(world.counts.energy.largestGain(), gain, 1e-3 * gain);
    EXPECT_NEAR(world.counts.energy.excess(), gain, 1e-3 * gain);
}

} // namespace
} // namespace frostfill
