// SPDX-License-Identifier: MIT
// One sphere that rolls while it fills the object, against closed forms.
#include "simulation/motion/rolling.hpp"

#include "oracle/rolling.hpp"
#include "simulation/engine/fast_engine.hpp"
#include "simulation/freezing/support_at_rest.hpp"
#include "simulation/motion/free_flight.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

constexpr double kFloorOfSlope = -20; // of a box that leans, in its own frame
constexpr double kHalfLength = 50;    // of its length

/// A box that leans by `slope`, so that its floor leads down along +x.
class Slope
{
public:
    explicit Slope(double slope) : lean_(Eigen::AngleAxisd(-slope, Vector3d::UnitZ())) {}

    [[nodiscard]] TriangleMesh mesh() const
    {
        TriangleMesh mesh =
            shapes::box({-kHalfLength, kFloorOfSlope, -10}, {kHalfLength, -kFloorOfSlope, 10}, 4);
        for (Vector3d& vertex : mesh.vertices)
        {
            vertex = lean_ * vertex;
        }
        return mesh;
    }
    /// On the floor.
    [[nodiscard]] Vector3d at(double along) const
    {
        return lean_ * Vector3d(along, kFloorOfSlope + 1, 0);
    }
    [[nodiscard]] double alongOf(const Vector3d& place) const
    {
        return (lean_.inverse() * place).x();
    }
    [[nodiscard]] Vector3d down() const { return lean_ * Vector3d::UnitX(); }

private:
    Eigen::Quaterniond lean_;
};

struct State
{
    double along;
    double speed;
};

/// After a time on a slope, from the middle of it.
State rolled(double slope, const RollingLaw& law, double speed, double time, double dt)
{
    const Slope plane(slope);
    const auto world = smallWorld(plane.mesh());
    FreeFlight flight(*world, {.restitution = {}, .rolling = law});
    world->spheres.add(plane.at(0), 1, 0);
    RunningSpheres& running = world->spheres.running();
    running.velocity[0] = speed * plane.down();
    const auto steps = std::lround(time / dt);
    for (long step = 0; step < steps; ++step)
    {
        flight.advance(0, dt);
    }
    EXPECT_LT((running.position[0] - plane.at(plane.alongOf(running.position[0]))).norm(), 1e-6);
    return {plane.alongOf(running.position[0]), running.velocity[0].dot(plane.down())};
}

TEST(Rolling, AcceleratesDownASlopeAsItsResistanceSays)
{
    for (const double slope : {0.1, 0.3, 0.6})
    {
        for (const double dt : {0.02, 0.25})
        {
            const double resistance = 0.05;
            const State state = rolled(slope, {1, resistance}, 0.5, 5, dt);
            const double a = oracle::rollingDown(slope, resistance);
            EXPECT_NEAR(state.speed, 0.5 + 5 * a, 1e-9) << slope;
            EXPECT_NEAR(state.along, 0.5 * 5 + a * 25 / 2, 1e-6) << slope;
        }
    }
}

TEST(Rolling, EndsOnTheLevelAfterTheWayThatResistanceLeaves)
{
    const double resistance = 0.2;
    for (const double dt : {0.01, 0.3})
    {
        const State state = rolled(0, {1, resistance}, 1.5, 30, dt);
        EXPECT_EQ(state.speed, 0);
        EXPECT_NEAR(state.along, 1.5 * 1.5 / (2 * -oracle::rollingDown(0, resistance)), 1e-6);
    }
}

TEST(Rolling, EndsOnASlopeWhoseTangentIsBelowTheResistanceAndNotOnASteeperOne)
{
    const double resistance = 0.2;
    const double slope = std::atan(0.8 * resistance);
    const State stands = rolled(slope, {1, resistance}, 0.6, 60, 0.1);
    EXPECT_EQ(stands.speed, 0);
    EXPECT_NEAR(stands.along, 0.36 / (2 * -oracle::rollingDown(slope, resistance)), 1e-6);
    EXPECT_NEAR(rolled(std::atan(0.99 * resistance), {1, resistance}, 0, 5, 0.1).along, 0, 1e-12);
    EXPECT_GT(rolled(std::atan(1.01 * resistance), {1, resistance}, 0, 20, 0.1).along, 0.1);
}

// It has no spin that would carry it farther.
TEST(Rolling, IsSlowedUphillByAllOfItsWeightAlongTheSlope)
{
    const double resistance = 0.2;
    const double slope = std::atan(0.8 * resistance);
    const State state = rolled(slope, {1, resistance}, -0.6, 60, 0.1);
    const double slows = std::sin(slope) - oracle::rollingDown(0, resistance) * std::cos(slope);
    EXPECT_EQ(state.speed, 0);
    EXPECT_NEAR(state.along, -0.36 / (2 * slows), 1e-6);
}

TEST(Rolling, SlipsWhereFrictionIsTooLittleToTurnIt)
{
    const double slope = 0.6;
    const double resistance = 0.05;
    const double needed =
        oracle::frictionToRoll(slope) + 5.0 / 7 * resistance; // both torques by friction
    const double less = 0.98 * needed;
    EXPECT_NEAR(rolled(slope, {less, resistance}, 0, 5, 0.1).speed,
                5 * oracle::slidingDown(slope, less), 1e-9);
    EXPECT_NEAR(rolled(slope, {1.02 * needed, resistance}, 0, 5, 0.1).speed,
                5 * oracle::rollingDown(slope, resistance), 1e-9);
    // What would not roll slips all the same where friction does not hold it.
    EXPECT_GT(rolled(0.3, {0.2, 1}, 0, 5, 0.1).speed, 0.1);
}

// The reduced radius of two equal spheres is half of their own.
TEST(Rolling, OnASphereTakesTwiceTheResistance)
{
    const double lean = 0.1;
    for (const double share : {0.97, 1.03})
    {
        const auto world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}, 4));
        addResting(*world, {0, -9, 0});
        const RollingLaw law{1, share * 2 * std::tan(lean)};
        FreeFlight flight(*world, {.restitution = {}, .rolling = law});
        const Vector3d start(2 * std::sin(lean), -9 + 2 * std::cos(lean), 0);
        world->spheres.add(start, 1, 0);
        for (int step = 0; step < 100; ++step)
        {
            flight.advance(0, 0.1);
        }
        const double moved = (world->spheres.running().position[0] - start).norm();
        EXPECT_EQ(moved<1e-6, share> 1) << share << ": " << moved;
        EXPECT_EQ(flight.isHeld(0), share > 1);
    }
}

TEST(Rolling, NeverGainsEnergy)
{
    const auto world = smallWorld(shapes::torus(8, 3.5, 24, 12));
    FreeFlight flight(*world, {.restitution = {}, .rolling = {0.5, 0.1}});
    world->spheres.add({8, 1, 0}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    running.velocity[0] = {0.5, 0.3, 1};
    double energy = running.velocity[0].squaredNorm() / 2 + running.position[0].y();
    for (int step = 0; step < 4000; ++step)
    {
        flight.advance(0, 0.05);
        const double now = running.velocity[0].squaredNorm() / 2 + running.position[0].y();
        ASSERT_LE(now, energy + 1e-9) << step;
        energy = now;
    }
    EXPECT_EQ(running.velocity[0].norm(), 0) << "it has come to rest";
}

TEST(Rolling, IsNothingWithoutResistanceWhateverTheFriction)
{
    const Slope plane(0.3);
    Vector3d ends[2];
    for (const int k : {0, 1})
    {
        const auto world = smallWorld(plane.mesh());
        const RollingLaw law{k == 0 ? 0 : 0.7, 0};
        FreeFlight flight(*world, {.restitution = {}, .rolling = law});
        world->spheres.add(plane.at(0) + Vector3d(0, 2, 0), 1, 0);
        for (int step = 0; step < 60; ++step)
        {
            flight.advance(0, 0.1);
        }
        ends[k] = world->spheres.running().position[0];
    }
    EXPECT_EQ(ends[0], ends[1]);
}

/// A world on a slope of 0.15 whose spheres settle with this rolling friction.
std::unique_ptr<World> leaning(const Slope& plane, double rollingFriction)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 1;
    scene.spheres.count = 1;
    scene.rest.mode = Rest::joint;
    scene.rest.friction = 0.5;
    scene.rest.rollingFriction = rollingFriction;
    return std::make_unique<World>(scene, plane.mesh());
}

// Without, it goes down to the wall.
TEST(Rolling, LetsASphereFreezeWhereItStandsOnASlope)
{
    const Slope plane(0.15);
    for (const double rollingFriction : {0.0, 0.3})
    {
        const auto world = leaning(plane, rollingFriction);
        FastEngine engine(*world);
        const Vector3d above = plane.at(0) + Vector3d(0, 0.5, 0);
        const PlacedSphere one{above, 1};
        engine.releaseAt(std::span(&one, 1));
        while (world->spheres.running().size() > 0 && engine.step())
        {
        }
        ASSERT_EQ(world->spheres.resting().size(), 1u);
        const double along = plane.alongOf(world->spheres.position(0));
        if (rollingFriction > 0)
        {
            EXPECT_EQ(world->counts.overdue, 0u);
            EXPECT_NEAR(along, 0, 2);
        }
        else
        {
            EXPECT_NEAR(along, kHalfLength - 1, 1e-3);
        }
        EXPECT_TRUE(SupportAtRest(*world).carries(0));
    }
}

TEST(Rolling, CarriesAtRestUpToItsResistanceAndFriction)
{
    const Slope plane(0.15);
    for (const double share : {0.95, 1.05})
    {
        const auto world = leaning(plane, share * std::tan(0.15));
        EXPECT_EQ(SupportAtRest(*world).carries(world->spheres.addResting(plane.at(0), 1, 0)),
                  share > 1);
    }
}

TEST(RollingLaw, GoesByTheSmallerFriction)
{
    Scene scene;
    scene.rest.friction = 0.4;
    scene.rest.rollingFriction = 0.1;
    EXPECT_EQ(RollingLaw::of(scene).friction, 0.4);
    scene.rest.wallFriction = 0.6;
    EXPECT_EQ(RollingLaw::of(scene).friction, 0.4);
    scene.rest.wallFriction = 0.2;
    EXPECT_EQ(RollingLaw::of(scene).friction, 0.2);
    EXPECT_EQ(RollingLaw::of(scene).resistance, 0.1);
    scene.spheres.radius = Radii(0.1, 0.2);
    EXPECT_FALSE(RollingLaw::of(scene).any()) << "sizes differ";
}

} // namespace
} // namespace frostfill
