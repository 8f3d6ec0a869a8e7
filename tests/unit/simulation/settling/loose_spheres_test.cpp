// SPDX-License-Identifier: MIT
#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "unit/simulation/settling/bench.hpp"

#include <gtest/gtest.h>

/// What is held against rolling by nothing but balance, while piles settle by impulses.
namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// Speed after a time, from a speed, of one that drag slows in each step.
double slowed(double speed, double acceleration, double drag, double time)
{
    for (int step = 0; step < std::lround(time / kStepOfImpulses); ++step)
    {
        speed = (speed + kStepOfImpulses * acceleration) * (1 - kStepOfImpulses * drag);
    }
    return speed;
}

void advanceLooks(GranularMotion& motion, int looks, bool givesWay = false)
{
    for (int look = 0; look < looks; ++look)
    {
        motion.advanceByImpulses(kTimeOfLook, {0, kDrag}, givesWay);
    }
}

TEST(LooseSpheres, RollNextToWithoutDragFromTheFirstLookOn)
{
    const double slope = 5 * kDegree;
    Bench bench(slope);
    const auto ball = bench.add({-8, -9 + kGapAtRest / 2, 0});
    GranularMotion& motion = bench.start(0.5);
    advanceLooks(motion, 7);
    const double acceleration = oracle::rollingDown(slope);
    const double first = slowed(0, acceleration, kDrag, kTimeOfLook);
    const double speed = slowed(first, acceleration, kDragOfLoose, 6 * kTimeOfLook);
    EXPECT_NEAR(bench.velocity(ball).x(), speed, 1e-6 * speed);
    EXPECT_NEAR(bench.spin(ball).z(), -speed, 1e-6 * speed);
}

TEST(LooseSpheres, AreNotThoseThatSlide)
{
    const double slope = 30 * kDegree;
    Bench bench(slope);
    const auto ball = bench.add({-8, -9 + kGapAtRest / 2, 0});
    GranularMotion& motion = bench.start(0);
    advanceLooks(motion, 6);
    EXPECT_EQ(motion.unrest().loose, 0U);
    EXPECT_NEAR(bench.velocity(ball).x(), slowed(0, std::sin(slope), kDrag, 3), 1e-6);
}

// On two that touch, along z, a little aside.
std::uint32_t addOnTwo(Bench& bench, double aside)
{
    bench.add({0, -9, 1});
    bench.add({0, -9, -1});
    return bench.add({aside, -9 + std::sqrt(3 - aside * aside), 0});
}

TEST(LooseSpheres, RollOffTwoOthersAndAreKnownBefore)
{
    Bench bench;
    const auto top = addOnTwo(bench, 0.005);
    GranularMotion& motion = bench.start(0.5);
    motion.advanceByImpulses(1, {0, kDrag}, true);
    EXPECT_GT(bench.place(top).y(), -9 + 1.7);
    EXPECT_LT(motion.unrest().missing, kMissingOnMoving) << "it hardly moves yet";
    EXPECT_GT(motion.unrest().loose, 0U);
    advanceLooks(motion, 60, true);
    EXPECT_NEAR(bench.place(top).y(), -9, 1e-3);
}

TEST(LooseSpheres, AreNotWhatThreeCarryNorWhatStandsStill)
{
    Bench bench;
    for (const Vector3d& place : oracle::threeTouching(-9))
    {
        bench.add(place);
    }
    bench.add({0, -9 + oracle::aboveThree(), 0});
    GranularMotion& motion = bench.start(1.05 * oracle::frictionOfPyramid());
    motion.advanceByImpulses(30, {0, kDrag}, true);
    EXPECT_EQ(motion.unrest().loose, 0U);
    EXPECT_LT(motion.unrest().speed, 1e-6);
}

TEST(LooseSpheres, AreAtRestOnceTheyAreSlow)
{
    for (const double factor : {0.5, 2.0})
    {
        Bench bench;
        const auto ball = bench.add({0, -9 + kGapAtRest / 2, 0});
        GranularMotion& motion = bench.start(0.5);
        const double speed = factor * kSpeedOfMoving;
        bench.velocity(ball) = {speed, 0, 0};
        motion.setSpin(ball, {0, 0, -speed});
        motion.advanceByImpulses(2 * kStepOfImpulses, {0, 0}, false);
        EXPECT_EQ(motion.unrest().loose, factor > 1 ? 1U : 0U);
    }
}

TEST(LooseSpheres, AreNotHeldByThoseThatTouchAndDoNotPush)
{
    Bench bench(5 * kDegree);
    bench.add({-8, -9 + kGapAtRest / 2, -2});
    const auto middle = bench.add({-8, -9 + kGapAtRest / 2, 0});
    const auto outer = bench.add({-8, -9 + kGapAtRest / 2, 2});
    advanceLooks(bench.start(0.5), 7);
    EXPECT_GT(bench.velocity(outer).x(), 0.1);
    EXPECT_NEAR(bench.velocity(middle).x(), bench.velocity(outer).x(), 1e-6);
}

// Nothing but friction holds it, and resists rolling. What a contact forgets is stretched anew.
TEST(LooseSpheres, CreepDownASlopeByWhatContactsForget)
{
    const double slope = 5 * kDegree;
    Bench bench(slope);
    const auto ball = bench.addOnFloor(0);
    GranularMotion& motion = bench.start(0.5, 2 * std::tan(slope));
    motion.advanceByImpulses(10, {0, kDrag}, true);
    const double before = bench.place(ball).x();
    motion.advanceByImpulses(10, {0, kDrag}, true);
    const double stiffness = kStiffnessOfImpulses * Bench::kStiff * kTangentialStiffness;
    const double speed = kSlideForgotten * std::sin(slope) / stiffness * (1 - kStepOfFew * kDrag);
    EXPECT_NEAR(bench.place(ball).x() - before, 10 * speed, 0.05 * 10 * speed);
}

} // namespace
} // namespace frostfill
