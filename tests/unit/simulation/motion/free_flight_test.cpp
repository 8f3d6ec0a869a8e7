// SPDX-License-Identifier: MIT
#include "simulation/motion/free_flight.hpp"

#include "oracle/motion.hpp"
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
    RunningSpheres& running = world->spheres.running();
};

TEST_F(FreeFlightTest, BallisticMotionIsExact)
{
    FreeFlight flight(*world, {});
    for (const double dt : {0.01, 0.1, 0.5})
    {
        world->spheres.add({0, 0, 0}, 1, 0);
        const std::uint32_t row = running.size() - 1;
        running.velocity[row] = {1.5, 2, -0.5};
        const int steps = static_cast<int>(std::lround(5 / dt));
        for (int step = 1; step <= steps; ++step)
        {
            flight.advance(row, dt);
            const double t = step * dt;
            const Eigen::Vector3d expected = oracle::thrown({1.5, 2, -0.5}, t);
            ASSERT_LT((running.position[row] - expected).norm(), 1e-12 * (1 + t))
                << dt << " " << step;
        }
    }
}

TEST_F(FreeFlightTest, BounceReturnsTheSquareOfTheRestitution)
{
    FreeFlight::Settings settings;
    settings.restitution.coefficient = 0.7;
    settings.damping = 0;
    FreeFlight flight(*world, settings);
    world->spheres.add({0.3, -29, 0.2}, 1, 0);
    const std::uint32_t row = running.size() - 1;
    double apex = -39;
    bool bounced = false;
    for (int step = 0; step < 20000 && running.position[row].y() < -28; ++step)
    {
        const double before = running.velocity[row].y();
        flight.advance(row, 1e-3);
        bounced = bounced || (before < 0 && running.velocity[row].y() > 0);
        apex = bounced ? std::max(apex, running.position[row].y()) : apex;
        if (bounced && running.velocity[row].y() < 0)
        {
            break;
        }
    }
    EXPECT_NEAR(apex + 39, oracle::bounceApex(10, 0.7), 1e-2);
}

TEST_F(FreeFlightTest, EnergyNeverGrows)
{
    for (const double restitution : {0.0, 0.5, 1.0})
    {
        for (const double dt : {0.01, 0.165, 0.5})
        {
            FreeFlight::Settings settings;
            settings.restitution.coefficient = restitution;
            FreeFlight flight(*world, settings);
            world->spheres.add({-10, 10, 3}, 1, 0);
            const std::uint32_t row = running.size() - 1;
            running.velocity[row] = {4, 1, 2.5};
            double energy = running.velocity[row].squaredNorm() / 2 + running.position[row].y();
            for (int step = 0; step < 2000; ++step)
            {
                flight.advance(row, dt);
                const double now =
                    running.velocity[row].squaredNorm() / 2 + running.position[row].y();
                ASSERT_LE(now, energy + 1e-9) << restitution << " " << dt << " " << step;
                energy = now;
            }
        }
    }
}

TEST_F(FreeFlightTest, SeesWhatIsAtRestAnewOnceItHasForgottenItsNeighbours)
{
    FreeFlight flight(*world, {});
    world->spheres.add({0, 0, 0}, 1, 0);
    flight.findContacts(0, 0.2);
    world->spheres.addResting({0, -2.1, 0}, 1, 0);
    flight.findContacts(0, 0.2);
    EXPECT_TRUE(flight.normals(0).empty()) << "nobody has told it";
    flight.forgetNeighbours();
    flight.findContacts(0, 0.2);
    ASSERT_EQ(flight.normals(0).size(), 1u);
    EXPECT_EQ(flight.normals(0)[0], Eigen::Vector3d(0, 1, 0));
}

// Sliding does not notice how finely a plane is cut.
TEST_F(FreeFlightTest, SlidesAlikeOverFewAndManyTriangles)
{
    const auto run = [](int cuts)
    {
        const auto room = smallWorld(shapes::box({-20, -20, -20}, {20, 20, 20}, cuts));
        FreeFlight::Settings settings;
        settings.damping = 0;
        FreeFlight flight(*room, settings);
        room->spheres.add({-15, -19, -7}, 1, 0);
        RunningSpheres& runners = room->spheres.running();
        const std::uint32_t row = runners.size() - 1;
        runners.velocity[row] = {2, 0, 1.1};
        for (int step = 0; step < 100; ++step)
        {
            flight.advance(row, 0.1);
        }
        return Eigen::Vector3d(runners.position[row]);
    };
    const Eigen::Vector3d expected(-15 + 20, -19, -7 + 11);
    for (const int cuts : {1, 3, 20})
    {
        EXPECT_LT((run(cuts) - expected).norm(), 1e-9) << cuts;
    }
}

} // namespace
} // namespace frostfill
