// SPDX-License-Identifier: MIT
#include "simulation/motion/free_flight.hpp"

#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

// Units of the run: r = 1, g = 1.
class FreeFlightTest : public ::testing::Test
{
protected:
    std::unique_ptr<World> world = smallWorld(shapes::box({-20, -40, -20}, {20, 40, 20}, 4));
};

TEST_F(FreeFlightTest, BallisticMotionIsExact)
{
    const FreeFlight flight(*world, {});
    for (const double dt : {0.01, 0.1, 0.5})
    {
        Runner runner;
        runner.restart(0, {0, 0, 0}, 1);
        runner.velocity = {1.5, 2, -0.5};
        const int steps = static_cast<int>(std::lround(5 / dt));
        for (int step = 1; step <= steps; ++step)
        {
            flight.advance(runner, dt);
            const double t = step * dt;
            const Eigen::Vector3d expected(1.5 * t, 2 * t - t * t / 2, -0.5 * t);
            ASSERT_LT((runner.position - expected).norm(), 1e-12 * (1 + t)) << dt << " " << step;
        }
    }
}

TEST_F(FreeFlightTest, BounceReturnsTheSquareOfTheRestitution)
{
    FreeFlight::Settings settings;
    settings.restitution = 0.7;
    settings.damping = 0;
    const FreeFlight flight(*world, settings);
    Runner runner;
    runner.restart(0, {0.3, -29, 0.2}, 1);
    double apex = -39;
    bool bounced = false;
    for (int step = 0; step < 20000 && runner.position.y() < -28; ++step)
    {
        const double before = runner.velocity.y();
        flight.advance(runner, 1e-3);
        bounced = bounced || (before < 0 && runner.velocity.y() > 0);
        apex = bounced ? std::max(apex, runner.position.y()) : apex;
        if (bounced && runner.velocity.y() < 0)
        {
            break;
        }
    }
    EXPECT_NEAR((apex + 39) / 10, 0.49, 1e-3);
}

TEST_F(FreeFlightTest, EnergyNeverGrows)
{
    for (const double restitution : {0.0, 0.5, 1.0})
    {
        for (const double dt : {0.01, 0.165, 0.5})
        {
            FreeFlight::Settings settings;
            settings.restitution = restitution;
            const FreeFlight flight(*world, settings);
            Runner runner;
            runner.restart(0, {-10, 10, 3}, 1);
            runner.velocity = {4, 1, 2.5};
            double energy = runner.velocity.squaredNorm() / 2 + runner.position.y();
            for (int step = 0; step < 2000; ++step)
            {
                flight.advance(runner, dt);
                const double now = runner.velocity.squaredNorm() / 2 + runner.position.y();
                ASSERT_LE(now, energy + 1e-9) << restitution << " " << dt << " " << step;
                energy = now;
            }
        }
    }
}

// Sliding does not notice how finely a plane is cut.
TEST_F(FreeFlightTest, SlidesAlikeOverFewAndManyTriangles)
{
    const auto run = [](int cuts)
    {
        const auto room = smallWorld(shapes::box({-20, -20, -20}, {20, 20, 20}, cuts));
        FreeFlight::Settings settings;
        settings.damping = 0;
        const FreeFlight flight(*room, settings);
        Runner runner;
        runner.restart(0, {-15, -19, -7}, 1);
        runner.velocity = {2, 0, 1.1};
        for (int step = 0; step < 100; ++step)
        {
            flight.advance(runner, 0.1);
        }
        return runner.position;
    };
    const Eigen::Vector3d expected(-15 + 20, -19, -7 + 11);
    for (const int cuts : {1, 3, 20})
    {
        EXPECT_LT((run(cuts) - expected).norm(), 1e-9) << cuts;
    }
}

} // namespace
} // namespace frostfill
