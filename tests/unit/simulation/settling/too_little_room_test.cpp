// SPDX-License-Identifier: MIT
// A row of spheres that is longer than its place: soft ones get into it, hard ones have to get out.
#include "support/shapes.hpp"
#include "unit/simulation/settling/bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

const GranularMotion::Course kHardens = {1 / kHardening, kDrag, kFastestHardening};

TEST(TooLittleRoom, IsLeftByARowThatSlipsOutSlowly)
{
    constexpr double kLacks = 6e-4; // of the height of three
    Bench bench(0, shapes::box({-4, 0, -4}, {4, 6 - kLacks, 4}));
    for (int k = 0; k < 3; ++k)
    {
        bench.add({1e-4 * (k == 1), 1 - kLacks / 6 + k * (2 - kLacks / 3), 0});
    }
    GranularMotion& motion = bench.start(0.05);
    double fastest = 0;
    for (int k = 0; k < 200; ++k)
    {
        motion.advance(0.5, kHardens);
        fastest = std::max(fastest, motion.unrest().speed);
    }
    EXPECT_LE(fastest, kFastestHardening);
    EXPECT_LT(motion.unrest().overlap, 2 * kGapAtRest);
    // Where the row fits it leans: each of two steps is 2 long and lacks half of the height.
    const double least = std::sqrt(4 - std::pow(2 - kLacks / 2, 2));
    const double leans = std::hypot(bench.place(1).x() - bench.place(0).x(),
                                    bench.place(1).z() - bench.place(0).z());
    EXPECT_GT(leans, 0.95 * least);
    for (std::uint32_t row = 0; row < 3; ++row)
    {
        EXPECT_LT(bench.place(row).cwiseAbs().maxCoeff(), 6) << row;
    }
}

// Walls that lean towards each other below hold a sphere that was pressed between them.
TEST(TooLittleRoom, IsLeftUpwardsByASphereBetweenWalls)
{
    const auto slotOf = [](double top)
    {
        TriangleMesh mesh = shapes::box({-0.95, -4, -4}, {0.95, 4, 4});
        for (Vector3d& vertex : mesh.vertices)
        {
            vertex.x() *= vertex.y() > 0 ? top : 1;
        }
        return mesh;
    };
    for (const auto& [top, isLifted] : {std::pair(1.3, true), {1.0, false}})
    {
        Bench bench(0, slotOf(top));
        bench.add({0, -2.9, 0});
        GranularMotion& motion = bench.start(0.3);
        motion.advance(0.01, kHardens);
        ASSERT_GT(motion.unrest().wallOverlap, kOverlapRelieved);
        EXPECT_EQ(motion.liftOutOfWalls(), isLifted);
        motion.advance(0.01, kHardens);
        EXPECT_EQ(motion.unrest().wallOverlap < kGapAtRest, isLifted);
    }
}

TEST(TooLittleRoom, IsNotHeldByFriction)
{
    const Spring spring({.stiffness = 100}, 1, 1);
    const Touch slides = {Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitX(), 0};
    ContactStep step{.dt = 0.01, .hardening = 1, .slipsFrom = 0.1};
    ContactMemory memory;
    memory.held = 9.9;
    EXPECT_LT(forceOf(spring, 0.3, 0.1, 0.5, slides, step, memory).force.x(), 0);
    memory.held = 10.1;
    const SurfaceForce slips = forceOf(spring, 0.3, 0.1, 0.5, slides, step, memory);
    EXPECT_EQ(slips.force, Vector3d(0, 10.1, 0));
    EXPECT_TRUE(slips.torque.isZero(0) && slips.moment.isZero(0));
    EXPECT_TRUE(memory.slide.isZero(0) && memory.roll.isZero(0));
    // When all flows again, the force is no more than that.
    step.hardening = 0;
    (void)forceOf(spring, 0.3, 0.1, 0.5, slides, step, memory);
    EXPECT_EQ(memory.held, 10);
    // However long it hardens, there is an end.
    step.hardening = 1e9;
    const Touch overlaps = {Vector3d::UnitY(), Vector3d::Zero(), Vector3d::Zero(), 1e-3};
    (void)forceOf(spring, 0.3, 0.1, 0.5, overlaps, step, memory);
    EXPECT_EQ(memory.held, kMostOverSlipping * 10);
}

TEST(TooLittleRoom, IsNothingThatReliefCanTakeAway)
{
    // Floor and ceiling, all but parallel, both press on one sphere: the way out is far to the
    // side.
    ContactMemory floor;
    ContactMemory ceiling;
    floor.held = 2;
    OverlapRelief relief;
    const Vector3d down = Vector3d(0.05, -1, 0).normalized();
    relief.add({0, LoadedContact::kWall, Vector3d::UnitY(), 1e-2, 400, &floor});
    relief.add({0, LoadedContact::kWall, down, 1e-2, 400, &ceiling});
    EXPECT_FALSE(relief.solve({1}));
    EXPECT_EQ(floor.held, 2);
    EXPECT_EQ(ceiling.held, 0);
}

} // namespace
} // namespace frostfill
