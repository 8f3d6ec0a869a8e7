// SPDX-License-Identifier: MIT
#include "simulation/world/frame_of_run.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

ObjectMotion motionOf(const MoveSettings& move)
{
    FrameOfRun frame; // a unit of length is one radius, a unit of time sqrt(r/g)
    return ObjectMotion(move, frame, 10);
}

TEST(FrameOfRun, TakesPlacesThereAndBack)
{
    for (const Axis up : {Axis::x, Axis::y, Axis::z})
    {
        Scene scene;
        scene.object.up = up;
        const FrameOfRun frame(scene, {Vector3d(1, 2, 3), Vector3d(5, 4, 9)}, 0.5);
        const Vector3d top = Vector3d(3, 3, 6) + Vector3d::Unit(static_cast<int>(up));
        EXPECT_EQ(frame.toRun(top), Vector3d(0, 2, 0)) << "y is up, in radii from the middle";
        EXPECT_EQ(frame.toMesh({0, 2, 0}), top);
        EXPECT_EQ(frame.toMesh(frame.toRun({1, 4, 7})), Vector3d(1, 4, 7));
    }
}

TEST(ObjectMotion, PullsStraightDownWhenNothingMoves)
{
    const ObjectMotion still = motionOf({});
    EXPECT_EQ(still.duration(), 0);
    EXPECT_EQ(still.pullAt(5).at({1, 2, 3}, {4, 5, 6}), Vector3d(0, -1, 0));
    EXPECT_TRUE(still.poseAt(5).isApprox(Eigen::Isometry3d::Identity(), 0));
}

TEST(ObjectMotion, TurnsGravityBackByTheTilt)
{
    MoveSettings move;
    move.tilt = 30;
    move.duration = 50;
    const ObjectMotion tilted = motionOf(move);
    const Vector3d down = tilted.pullAt(60).direction({3, 0, 0});
    EXPECT_NEAR(down.y(), -std::cos(M_PI / 6), 1e-12);
    EXPECT_NEAR(down.x(), 0.5, 1e-12); // towards the side that is lower now
    EXPECT_NEAR((tilted.poseAt(60) * Vector3d(1, 0, 0)).y(), -0.5, 1e-12);
}

// The oracle: a free body falls straight in the room, so its way as seen from the object is known.
// Its second difference must be the acceleration that pullAt tells.
TEST(ObjectMotion, TellsTheAccelerationOfAFreeBodyAsTheObjectSeesIt)
{
    MoveSettings move;
    move.tilt = 70;
    move.turn = -200;
    move.shake = 0.4;
    move.frequency = 0.2;
    move.duration = 20;
    const ObjectMotion motion = motionOf(move);
    for (const double time : {1.0, 4.0, 9.5, 16.0, 19.0})
    {
        const auto seen = [&](double dt)
        {
            const Vector3d room = Vector3d(2, 1, -3) + dt * Vector3d(0.5, 1, 0.2) +
                                  0.5 * dt * dt * Vector3d(0, -1, 0);
            return Vector3d(motion.poseAt(time + dt).inverse() * room);
        };
        const double h = 1e-3;
        const Vector3d velocity = (seen(h) - seen(-h)) / (2 * h);
        const Vector3d acceleration = (seen(h) - 2 * seen(0) + seen(-h)) / (h * h);
        EXPECT_LT((motion.pullAt(time).at(seen(0), velocity) - acceleration).norm(), 2e-5) << time;
    }
}

Scene movedBox(double tilt, double shake)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.motion.mode = Motion::fall;
    scene.spheres.radius = 0.15;
    scene.spheres.count = 120;
    scene.move.tilt = tilt;
    scene.move.shake = shake;
    return scene;
}

std::unique_ptr<Simulation> finished(const Scene& scene)
{
    auto simulation = std::make_unique<Simulation>(scene, shapes::box({-1, -1, -1}, {1, 1, 1}, 4));
    while (simulation->step() && simulation->steps() < 100000)
    {
    }
    return simulation;
}

TEST(MovedObject, RunsToRestAgainCarriedInTheNewDirection)
{
    for (const auto& [tilt, shake] : {std::pair(35.0, 0.0), {180.0, 0.0}, {0.0, 0.05}})
    {
        const auto simulation = finished(movedBox(tilt, shake));
        EXPECT_TRUE(simulation->finished());
        EXPECT_EQ(simulation->restingCount(), simulation->sphereCount());
        EXPECT_EQ(simulation->sphereCount(), 120u);
        const QualityReport quality = simulation->quality();
        EXPECT_EQ(quality.unsupported, 0u) << tilt;
        EXPECT_EQ(quality.centresOutside, 0u) << tilt;
        EXPECT_LT(quality.maxOverlap, 1e-9) << tilt;
        EXPECT_LT(quality.maxWallOverlap, 1e-6) << tilt;
    }
}

TEST(MovedObject, HoldsTheSpheresOnItsLidWhenItStandsOnItsHead)
{
    const auto simulation = finished(movedBox(180, 0));
    double mean = 0;
    for (std::size_t id = 0; id < simulation->sphereCount(); ++id)
    {
        mean += simulation->sphere(id).centre.y() / static_cast<double>(simulation->sphereCount());
    }
    EXPECT_GT(mean, 0.2);
    Snapshot snapshot;
    simulation->capture(snapshot);
    EXPECT_NEAR(snapshot.pose.rotation(1, 1), -1, 1e-12);
}

TEST(MovedObject, LetsGoOnlyWhatIsNotCarriedAnyMore)
{
    // A tilt by less than any contact forgives: nothing moves at all.
    const auto still = finished(movedBox(0.001, 0));
    const auto tilted = finished(movedBox(0.2, 0));
    EXPECT_EQ(still->stateHash(), tilted->stateHash());
    // A small tilt: most move, as they lean on others, and a fifth stays to the bit.
    const auto leaning = finished(movedBox(12, 0));
    std::size_t stayed = 0;
    for (std::size_t id = 0; id < leaning->sphereCount(); ++id)
    {
        stayed += leaning->sphere(id).centre == tilted->sphere(id).centre ? 1 : 0;
    }
    EXPECT_GT(stayed, leaning->sphereCount() / 5);
    EXPECT_LT(stayed, leaning->sphereCount());
}

TEST(MovedObject, GivesTheSameBitsWithAnyThreadsAndWithoutDiscards)
{
    Scene scene = movedBox(35, 0.02);
    scene.threads = 1;
    const std::string one = finished(scene)->stateHash();
    scene.threads = 2;
    EXPECT_EQ(finished(scene)->stateHash(), one);
    scene.discard.rule = DiscardRule::none;
    EXPECT_EQ(finished(scene)->stateHash(), one);
}

TEST(MovedObject, NeedsDynamics)
{
    Scene scene = movedBox(10, 0);
    scene.motion.mode = Motion::descend;
    test::expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "move.tilt", "--motion");
}

} // namespace
} // namespace frostfill
