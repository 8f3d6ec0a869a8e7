// SPDX-License-Identifier: MIT
#include "oracle/rolling.hpp"
#include "unit/simulation/settling/bench.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(OneSphere, RollsDownAPlaneByFiveSeventhsOfGravity)
{
    const double slope = 20 * kDegree;
    Bench bench(slope);
    const auto ball = bench.addOnFloor(-8);
    bench.start(0.5);
    bench.advance(4);
    const double speed = 4 * oracle::rollingDown(slope);
    EXPECT_NEAR(bench.velocity(ball).x(), speed, 1e-3 * speed);
    EXPECT_NEAR(bench.place(ball).x(), -8 + 4 * speed / 2, 1e-3 * speed);
    EXPECT_NEAR(bench.spin(ball).z(), -bench.velocity(ball).x(), 1e-3) << "it rolls to the right";
    EXPECT_NEAR(bench.place(ball).y(), -9, 1e-4);
}

TEST(OneSphere, SlipsWhereFrictionIsTooLittleToRoll)
{
    const double slope = 60 * kDegree;
    const double friction = 0.3;
    ASSERT_LT(friction, oracle::frictionToRoll(slope));
    Bench bench(slope);
    const auto ball = bench.addOnFloor(-8);
    bench.start(friction);
    bench.advance(3);
    const double speed = 3 * oracle::slidingDown(slope, friction);
    EXPECT_NEAR(bench.velocity(ball).x(), speed, 1e-3 * speed);
    const double spin = 3 * oracle::spinOfSliding(slope, friction);
    EXPECT_NEAR(bench.spin(ball).z(), -spin, 2e-3 * spin);
}

TEST(OneSphere, RollsOrSlipsAtTheFrictionThatMechanicsSays)
{
    const double slope = 30 * kDegree;
    for (const double factor : {0.99, 1.01})
    {
        Bench bench(slope);
        const auto ball = bench.addOnFloor(-8);
        bench.start(factor * oracle::frictionToRoll(slope));
        bench.advance(4);
        const double slip = bench.velocity(ball).x() + bench.spin(ball).z();
        EXPECT_EQ(slip > 0.02, factor < 1) << "slips by " << slip;
    }
}

TEST(OneSphere, EndsRollingWithFiveSeventhsOfItsSpeed)
{
    Bench bench;
    const auto ball = bench.addOnFloor(-8);
    bench.start(0.3);
    bench.velocity(ball) = {2, 0, 0};
    bench.advance(5); // sliding ends after 2 * 2 / (7 * 0.3)
    const double speed = oracle::rollingAfterSliding(2);
    EXPECT_NEAR(bench.velocity(ball).x(), speed, 2e-3 * speed);
    EXPECT_NEAR(bench.spin(ball).z(), -speed, 2e-3 * speed);
}

TEST(OneSphere, BouncesWithTheRestitutionAskedFor)
{
    for (const double restitution : {0.2, 0.5, 0.9})
    {
        Bench bench;
        bench.world().pull.uniform.setZero();
        const auto ball = bench.add({0, -8.5, 0});
        bench.start(0, 0, restitution);
        bench.velocity(ball) = {0, -1, 0};
        bench.advance(1);
        EXPECT_NEAR(bench.velocity(ball).y(), restitution, 0.025) << "15 steps a contact";
    }
}

TEST(OneSphere, IsSlowedByABounceAsMuchAsFrictionCan)
{
    Bench bench;
    bench.world().pull.uniform.setZero();
    const auto ball = bench.add({-5, -8.5, 0});
    bench.start(0.1, 0, 0.5);
    bench.velocity(ball) = {3, -1, 0};
    bench.advance(1);
    const double slowed = oracle::slowedByBounce(1, bench.velocity(ball).y(), 0.1);
    EXPECT_NEAR(3 - bench.velocity(ball).x(), slowed, 1e-6);
    EXPECT_NEAR(bench.spin(ball).z(), -2.5 * slowed, 1e-5);
}

TEST(OneSphere, StaysOnASlopeThatRollingFrictionHolds)
{
    const double slope = 10 * kDegree;
    for (const double factor : {0.98, 1.02})
    {
        Bench bench(slope);
        const auto ball = bench.addOnFloor(-8);
        bench.start(1, factor * std::tan(slope));
        bench.advance(6);
        const bool stays = std::abs(bench.place(ball).x() + 8) < 0.01;
        EXPECT_EQ(stays, factor > 1) << bench.place(ball).x() + 8;
    }
    Bench bench(slope);
    const auto ball = bench.addOnFloor(-8);
    bench.start(1, 0.05);
    bench.advance(6);
    const double speed = 6 * oracle::rollingDown(slope, 0.05);
    EXPECT_NEAR(bench.velocity(ball).x(), speed, 0.01 * speed);
}

TEST(OneSphere, RollsOverAFloorOfManyTrianglesAsOverOne)
{
    const double slope = 20 * kDegree;
    Bench fine(slope, shapes::box({-10, -10, -10}, {10, 10, 10}, 13));
    const auto ball = fine.addOnFloor(-8);
    fine.start(0.5);
    fine.advance(4);
    EXPECT_NEAR(fine.velocity(ball).x(), 4 * oracle::rollingDown(slope), 2e-3);
    EXPECT_NEAR(fine.place(ball).y(), -9, 1e-4);
}

// Several triangles push it, whose normals differ by little.
TEST(OneSphere, IsPressedIntoARoundWallAsIntoAFlatOne)
{
    Bench bench(0, shapes::torus(3, 1.005, 100, 100));
    const auto ball = bench.add({0, -3, 0});
    bench.start(0.5);
    bench.motion().advance(20, {0, 1});
    EXPECT_LT(bench.velocity(ball).norm(), 1e-4);
    EXPECT_NEAR(bench.motion().unrest().overlap, 1 / Bench::kStiff, 0.5 / Bench::kStiff);
}

TEST(OneSphere, HasTurnedByTheWayThatItHasRolled)
{
    Bench bench(20 * kDegree);
    bench.world().scene.rest.orientation = true;
    const auto ball = bench.addOnFloor(-8);
    bench.start(0.5);
    bench.advance(4);
    const double way = bench.place(ball).x() + 8;
    ASSERT_GT(way, 1);
    const Eigen::AngleAxisd turned(bench.world().orientations.at(ball));
    EXPECT_NEAR(turned.angle(), way, 2e-3);
    EXPECT_NEAR(turned.axis().z(), -1, 1e-6) << "it rolls to the right";
}

} // namespace
} // namespace frostfill
