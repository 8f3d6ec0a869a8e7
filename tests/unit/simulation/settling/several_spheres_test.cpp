// SPDX-License-Identifier: MIT
#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "simulation/contact/contact.hpp"
#include "unit/simulation/settling/bench.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(SeveralSpheres, KeepMomentumAndAngularMomentumWhenTheyCollide)
{
    Bench bench;
    bench.world().pull.uniform.setZero();
    const auto a = bench.add({-2, 0, 0});
    const auto b = bench.add({1, 1, 0.3}, 0.7);
    GranularMotion& motion = bench.start(0.4, 0.1);
    bench.velocity(a) = {2, 0, 0.1};
    motion.setSpin(b, {0.3, -1, 2});
    const double mb = massOf(0.7);
    const auto momentum = [&] { return Vector3d(bench.velocity(a) + mb * bench.velocity(b)); };
    const auto angular = [&]
    {
        return Vector3d(bench.place(a).cross(bench.velocity(a)) +
                        mb * bench.place(b).cross(bench.velocity(b)) + 0.4 * bench.spin(a) +
                        0.4 * mb * 0.7 * 0.7 * bench.spin(b));
    };
    const Vector3d before = momentum();
    const Vector3d turning = angular();
    bench.advance(1.5);
    EXPECT_GT(bench.velocity(b).norm(), 0.1) << "they met";
    EXPECT_LT((momentum() - before).norm(), 1e-12);
    EXPECT_LT((angular() - turning).norm(), 1e-3) << "the lever is the radius, overlap or not";
}

TEST(SeveralSpheres, NeverGainEnergy)
{
    for (const double friction : {0.0, 0.5})
    {
        Bench bench;
        addCrowd(bench, 5);
        GranularMotion& motion = bench.start(friction, 0.1, 0.6);
        bench.advance(0.01);
        const double start = motion.energy();
        double before = start;
        double fall = 0;
        for (int k = 0; k < 60; ++k)
        {
            bench.advance(0.1);
            const double now = motion.energy();
            EXPECT_LT(now - before, 1e-3 * std::abs(start)) << "after " << k << " looks";
            before = now;
            fall = std::max(fall, motion.unrest().kinetic);
        }
        EXPECT_GT(fall, 10) << "they did fall";
    }
}

TEST(SeveralSpheres, MoveTheSameOnAnyNumberOfThreads)
{
    std::vector<Vector3d> places;
    for (const int threads : {1, 3})
    {
        Bench bench(0.2, room(), threads);
        addCrowd(bench, 6);
        bench.start(0.3);
        bench.advance(3);
        const auto now = bench.world().spheres.running().position.all();
        if (places.empty())
        {
            places.assign(now.begin(), now.end());
        }
        EXPECT_TRUE(std::equal(now.begin(), now.end(), places.begin())) << threads;
    }
}

TEST(SeveralSpheres, StandAsAPyramidOrFallAtTheFrictionOfStatics)
{
    for (const double factor : {0.99, 1.01})
    {
        Bench bench;
        for (const Vector3d& place : oracle::threeTouching(-9))
        {
            bench.add(place);
        }
        const auto top = bench.add({0, -9 + oracle::aboveThree(), 0});
        bench.start(factor * oracle::frictionOfPyramid());
        bench.advance(30);
        const double sunk = -9 + oracle::aboveThree() - bench.place(top).y();
        EXPECT_EQ(sunk<0.01, factor> 1) << sunk;
    }
}

TEST(SeveralSpheres, AreHeldByWhatHasHardenedWithoutAnOverlap)
{
    Bench bench;
    bench.add({0, -9, 0});
    const auto high = bench.add({0, -7, 0});
    GranularMotion& motion = bench.start(0);
    motion.advance(20, {1 / kHardening, kDrag});
    EXPECT_LE(motion.unrest().overlap, 0);
    EXPECT_NEAR(bench.place(high).y(), -7 + kGapAtRest, 1.1 * kGapAtRest);
    EXPECT_LT(motion.unrest().missing, 1e-3);
    const double before = bench.place(high).y();
    motion.listAnew();
    motion.advance(1, {});
    EXPECT_NEAR(bench.place(high).y(), before, 0.1 / Bench::kStiff) << "forces go on";
}

TEST(SeveralSpheres, KeepTheirHoldWhenContactsGrowStiffer)
{
    const double slope = 0.2;
    Bench bench(slope);
    const auto ball = bench.addOnFloor(-8);
    GranularMotion& motion = bench.start(1, 1);
    motion.advance(10, {0, kDrag});
    const double before = bench.place(ball).x();
    motion.stiffen(2);
    motion.listAnew();
    motion.advance(1e-3, {0, kDrag});
    EXPECT_LT(std::abs(bench.velocity(ball).x()), 1e-5) << "friction is what it was";
    motion.advance(10, {0, kDrag});
    EXPECT_NEAR(bench.place(ball).x(), before, 1e-7);
    EXPECT_LT(motion.unrest().missing, 1e-3);
}

} // namespace
} // namespace frostfill
