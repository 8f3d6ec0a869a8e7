// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezer.hpp"

#include "simulation/freezing/tolerances.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

/// Whether a sphere gives way that did not, after a window in which it has gone so far.
bool yieldsAfter(double way, double rollingFriction)
{
    const auto world = smallWorld(shapes::box({-20, -20, -20}, {20, 20, 20}, 4));
    Threads threads(1);
    const auto release = makeRelease(*world, world->height, threads);
    SphereGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {.restitution = {}, .rolling = {0.5, rollingFriction}});
    RunningSpheres& running = world->spheres.running();
    PositionSolver solver(running, flight, threads, {.restitution = {}});
    Freezer freezer(*world, grid, release, flight, solver, threads, 1000);
    world->spheres.add({0, 0, 0}, 1, 0);
    solver.velocities().stopYielding(0);
    freezer.startWindow();
    running.position[0] += Eigen::Vector3d(0, -way, 0);
    SetSchedule sets(*world, 1000);
    freezer.freeze(sets);
    EXPECT_EQ(running.size(), 1U) << "it has moved";
    return solver.velocities().yields(0);
}

TEST(Freezer, LetsASphereGiveWayAgainThatHasLongStoodAndFallsNow)
{
    EXPECT_TRUE(yieldsAfter(1.01 * kYieldsAgain, 0.3));
    EXPECT_FALSE(yieldsAfter(0.99 * kYieldsAgain, 0.3)) << "it creeps";
    EXPECT_FALSE(yieldsAfter(1.01 * kYieldsAgain, 0)) << "nothing rolls";
}

// The guard looks at them after the step, not in its middle.
TEST(Freezer, TakesTheLowestFirstWhereSomeHeightsAreNoNumbers)
{
    const auto world = smallWorld(shapes::box({-20, -20, -20}, {20, 20, 20}, 4));
    Threads threads(1);
    const auto release = makeRelease(*world, world->height, threads);
    SphereGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {.restitution = {}});
    RunningSpheres& running = world->spheres.running();
    PositionSolver solver(running, flight, threads, {.restitution = {}});
    constexpr double kAgeLimit = 1;
    Freezer freezer(*world, grid, release, flight, solver, threads, kAgeLimit);
    SetSchedule sets(*world, kAgeLimit);
    for (std::uint32_t k = 0; k < 200; ++k)
    {
        const double x = 3 * (k % 13) - 18.0;
        const std::uint32_t line = k / 13;
        const double z = 3 * line - 18.0;
        const double y =
            k % 5 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.001 * (k * 97 % 200);
        world->spheres.add({x, y, z}, 1, 0);
    }
    freezer.startWindow();
    for (std::uint32_t row = 0; row < running.size(); ++row)
    {
        freezer.age(row, 2 * kAgeLimit); // all are overdue
    }
    freezer.freeze(sets);
    const SphereGrid& resting = world->spheres.resting();
    std::uint32_t before = 0;
    std::size_t finite = 0;
    for (std::uint32_t row = 0; row < resting.size(); ++row)
    {
        const std::uint32_t id = resting.id(row);
        if (id % 5 != 0)
        {
            EXPECT_LE(before, id * 97 % 200);
            before = id * 97 % 200;
            ++finite;
        }
    }
    EXPECT_GT(finite, 100U);
}

} // namespace
} // namespace frostfill
