// SPDX-License-Identifier: MIT
#include "simulation/engine/make_engine.hpp"
#include "support/expect_error.hpp"
#include "unit/simulation/settling/joint_scene.hpp"

#include <gtest/gtest.h>

#include <string>

namespace frostfill
{
namespace
{

/// Grains poured onto a floor that is wide enough for them.
double heapSlopeAt(double friction, double rollingFriction)
{
    Scene scene = jointScene(Motion::granular, friction);
    scene.judge.friction.reset();
    scene.spheres.radius = 0.05;
    scene.spheres.count = 350;
    scene.spheres.inlets = {{{0, -0.2, 0}, 0.2}};
    scene.rest.rollingFriction = rollingFriction;
    Simulation simulation(scene, shapes::box({-1, -1, -1}, {1, 0, 1}));
    run(simulation);
    const QualityReport report = simulation.quality();
    EXPECT_EQ(report.centresOutside, 0U);
    EXPECT_LE(report.maxOverlap, 1e-7);
    EXPECT_EQ(report.heaps.size(), 1U);
    EXPECT_EQ(report.heaps.front().spheres, 350U);
    return report.heaps.front().slope.value_or(0);
}

TEST(GranularEngine, FillsUntilFullAndAllRestTogether)
{
    for (const double friction : {0.0, 0.4})
    {
        Simulation simulation(jointScene(Motion::granular, friction), smallBox());
        run(simulation);
        EXPECT_TRUE(simulation.full());
        EXPECT_GT(simulation.sphereCount(), 70U);
        const QualityReport report = simulation.quality();
        ASSERT_TRUE(report.settling && report.equilibrium);
        EXPECT_TRUE(report.settling->settled);
        EXPECT_EQ(report.equilibrium->unbalanced, 0U);
        EXPECT_EQ(report.unsupported, 0U);
        EXPECT_LE(report.maxOverlap, 1e-7);
        EXPECT_EQ(report.centresOutside, 0U);
        EXPECT_LE(report.energyExcess, 1e-9);
    }
}

// Grains that bounce for ever are never calm: pouring must not wait until they are.
TEST(GranularEngine, EndsSoonWhereCollisionsLoseNothing)
{
    Scene scene = jointScene(Motion::granular, 0.3);
    scene.motion.restitution = 1;
    Simulation simulation(scene, smallBox());
    std::size_t steps = 0;
    while (simulation.step())
    {
        ++steps;
    }
    EXPECT_TRUE(simulation.full());
    EXPECT_TRUE(simulation.quality().settling->settled);
    EXPECT_LT(steps, 2000U);
}

TEST(GranularEngine, LetsASphereFallAsGalileoSays)
{
    Scene scene = jointScene(Motion::granular, 0.3);
    scene.spheres.count = 1;
    Simulation simulation(scene, shapes::box({-1, -4, -1}, {1, 4, 1}));
    Snapshot snapshot;
    ASSERT_TRUE(simulation.step());
    simulation.capture(snapshot);
    const double start = snapshot.time;
    const double high = snapshot.centres.at(0).y();
    const double speed = start * scene.motion.gravity;
    while (simulation.step() && simulation.time() < 0.9)
    {
        simulation.capture(snapshot);
        const double time = snapshot.time - start;
        const double fallen = speed * time + scene.motion.gravity * time * time / 2;
        EXPECT_NEAR(high - snapshot.centres.at(0).y(), fallen, 0.01);
    }
}

TEST(GranularEngine, EndsWithTheSameBitsOnAnyNumberOfThreadsAndWithDiscardsOff)
{
    expectSameBits(Motion::granular);
}

TEST(GranularEngine, HeapsLieSteeperTheMoreFrictionThereIs)
{
    const double flat = heapSlopeAt(0.05, 0);
    const double low = heapSlopeAt(0.3, 0.05);
    const double high = heapSlopeAt(0.8, 0.3);
    EXPECT_LT(flat, 8);
    EXPECT_GT(low, flat + 2);
    EXPECT_GT(high, low + 5);
}

TEST(GranularEngine, StartsWithWhatIsPlaced)
{
    Scene scene = jointScene(Motion::granular, 0.3);
    scene.spheres.count = 2;
    World world(scene, smallBox());
    const std::vector<PlacedSphere> placed = {{{0, -1, 0}, 1}, {{2.5, 1, 0}, 1}};
    const auto engine = makeEngine(world);
    engine->releaseAt(placed);
    while (engine->step())
    {
    }
    ASSERT_EQ(world.spheres.frozenCount() + world.spheres.discardedCount(), 2U);
    const double floor = -world.height / 2;
    for (std::uint32_t id = 0; id < 2; ++id)
    {
        EXPECT_NEAR(world.spheres.position(id).x(), placed[id].place.x(), 1e-3);
        EXPECT_NEAR(world.spheres.position(id).y(), floor + 1, 1e-4);
    }
    World other(scene, smallBox());
    const std::vector<PlacedSphere> crowded = {{{0, 0, 0}, 1}, {{0.5, 0, 0}, 1}};
    test::expectError(
        ErrorCode::badData, [&] { makeEngine(other)->releaseAt(crowded); }, "no room");
}

TEST(GranularEngine, TellsHowGrainsHaveTurnedWhenAskedAndChangesNoBit)
{
    Scene scene = jointScene(Motion::granular, 0.4);
    scene.spheres.count = 30;
    scene.object.up = Axis::z;
    Simulation plain(scene, smallBox());
    run(plain);
    scene.rest.orientation = true;
    Simulation asked(scene, smallBox());
    run(asked);
    EXPECT_EQ(asked.stateHash(), plain.stateHash());
    const auto find = [](const std::vector<ColumnValues>& columns, const char* name)
    { return findValues(columns, *findColumn(name)); };
    EXPECT_EQ(find(plain.columns(), "qw"), nullptr);
    const std::vector<ColumnValues> columns = asked.columns();
    std::size_t turned = 0;
    for (std::size_t id = 0; id < 30; ++id)
    {
        double squares = 0;
        for (const char* name : {"qx", "qy", "qz", "qw"})
        {
            ASSERT_NE(find(columns, name), nullptr);
            squares += std::pow(find(columns, name)->at(id), 2);
        }
        EXPECT_NEAR(squares, 1, 1e-3);
        EXPECT_GE(find(columns, "qw")->at(id), 0);
        turned += find(columns, "qw")->at(id) < 0.99 ? 1 : 0;
    }
    EXPECT_GT(turned, 10U);
}

TEST(GranularEngine, NeedsThatAllRestTogether)
{
    Scene scene = jointScene(Motion::granular, 0);
    scene.rest = {};
    scene.judge.friction.reset();
    test::expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "--rest");
}

} // namespace
} // namespace frostfill
