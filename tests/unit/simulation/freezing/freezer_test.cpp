// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezer.hpp"

#include "simulation/freezing/tolerances.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Whether a sphere gives way that did not, after a window in which it has gone so far.
bool yieldsAfter(double way, double rollingFriction)
{
    const auto world = smallWorld(shapes::box({-20, -20, -20}, {20, 20, 20}, 4));
    Threads threads(1);
    RestObservers observers(*world, world->height, threads);
    RunnerGrid grid(world->spheres.resting().frame());
    FreeFlight flight(*world, {.restitution = {}, .rolling = {0.5, rollingFriction}});
    RunningSpheres& running = world->spheres.running();
    PositionSolver solver(running, flight, threads, {.restitution = {}, .dt = 0.1});
    Freezer freezer(*world, grid, observers, flight, solver, threads, 1000);
    world->spheres.add({0, 0, 0}, 1, 0);
    solver.velocities().stopYielding(0);
    freezer.startWindow();
    running.position[0] += Eigen::Vector3d(0, -way, 0);
    EXPECT_TRUE(freezer.startLooking());
    EXPECT_FALSE(freezer.watchAhead(0)) << "it has moved";
    return solver.velocities().yields(0);
}

TEST(Freezer, LetsASphereGiveWayAgainThatHasLongStoodAndFallsNow)
{
    EXPECT_TRUE(yieldsAfter(1.01 * kYieldsAgain, 0.3));
    EXPECT_FALSE(yieldsAfter(0.99 * kYieldsAgain, 0.3)) << "it creeps";
    EXPECT_FALSE(yieldsAfter(1.01 * kYieldsAgain, 0)) << "nothing rolls";
}

} // namespace
} // namespace frostfill
