// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "unit/simulation/settling/joint_scene.hpp"

#include <gtest/gtest.h>

#include <string>

namespace frostfill
{
namespace
{

TEST(JointRest, FillsUpWhatHasSunkWhateverTheMotion)
{
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = jointScene(motion, 0.1);
        Simulation joint(scene, smallBox());
        run(joint);
        scene.rest = {};
        Simulation each(scene, smallBox());
        run(each);
        EXPECT_TRUE(joint.full());
        EXPECT_GT(joint.sphereCount(), each.sphereCount());
        const QualityReport report = joint.quality();
        ASSERT_TRUE(report.settling && report.equilibrium);
        EXPECT_TRUE(report.settling->settled);
        EXPECT_GT(report.settling->rounds, 1U);
        EXPECT_EQ(report.equilibrium->unbalanced, 0U);
        EXPECT_EQ(report.unsupported, 0U);
        EXPECT_LE(report.maxOverlap, 1e-7);
        EXPECT_EQ(report.centresOutside, 0U);
        EXPECT_FALSE(each.quality().settling);
    }
}

TEST(JointRest, EndsWithTheSameBitsOnAnyNumberOfThreadsAndWithDiscardsOff)
{
    expectSameBits(Motion::skip);
}

TEST(JointRest, StopsAtTheCount)
{
    Scene scene = jointScene(Motion::skip, 0.3);
    scene.spheres.count = 40;
    Simulation simulation(scene, smallBox());
    run(simulation);
    EXPECT_EQ(simulation.sphereCount(), 40U);
    EXPECT_FALSE(simulation.full());
    EXPECT_EQ(simulation.quality().settling->rounds, 1U);
    Snapshot snapshot;
    simulation.capture(snapshot);
    EXPECT_EQ(snapshot.running, 0U);
}

TEST(JointRest, ShowsEverySphereRunWhileAllSettle)
{
    Scene scene = jointScene(Motion::descend, 0.3);
    scene.spheres.count = 40;
    Simulation simulation(scene, smallBox());
    Snapshot snapshot;
    bool allRan = false;
    while (simulation.step())
    {
        simulation.capture(snapshot);
        allRan = allRan || snapshot.running == 40;
        EXPECT_EQ(simulation.settles(), snapshot.running == 40);
    }
    EXPECT_TRUE(allRan);
}

TEST(JointRest, NumbersGroupsOnWhereTheyHadEnded)
{
    Simulation simulation(jointScene(Motion::skip, 0), smallBox());
    run(simulation);
    Snapshot snapshot;
    simulation.capture(snapshot);
    EXPECT_TRUE(std::is_sorted(snapshot.groups.begin(), snapshot.groups.end()));
    EXPECT_GT(snapshot.groups.back(), snapshot.groups.size() / 20);
}

TEST(JointRest, IsRefusedWhereItHasNoMeaning)
{
    const auto refuse = [](auto change, const char* words)
    {
        Scene scene = jointScene(Motion::skip, 0.3);
        change(scene);
        test::expectError(
            ErrorCode::usage, [&] { Simulation(scene, smallBox()); }, words);
    };
    refuse([](Scene& s) { s.rest.mode = Rest::each; }, "--rest");
    refuse([](Scene& s) { s.move.tilt = 20; }, "stands still");
    refuse([](Scene& s) { s.rest.friction = -1; }, "--friction");
    refuse([](Scene& s) { s.rest.rollingFriction = 2; }, "rest.rolling_friction");
    refuse([](Scene& s) { s.rest.wallFriction = 9; }, "rest.wall_friction");
}

} // namespace
} // namespace frostfill
