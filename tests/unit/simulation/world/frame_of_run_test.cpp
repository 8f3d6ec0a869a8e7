// SPDX-License-Identifier: MIT
#include "simulation/world/frame_of_run.hpp"

#include "simulation/world/tolerances.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TriangleMesh cubesApart(double distance)
{
    TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    test::append(mesh,
                 shapes::box({distance, 2 * distance, 0}, {distance + 1, 2 * distance + 1, 1}));
    return mesh;
}

TEST(FrameOfRun, MovesPartsTogetherThatLieFarApart)
{
    Scene scene;
    scene.object.up = Axis::z;
    const TriangleMesh mesh = cubesApart(3000);
    const FrameOfRun frame(scene, mesh, boundingBox(mesh), 0.1);
    const TriangleMesh row = frame.toRun(mesh);
    EXPECT_NEAR(signedVolume(row), 2000, 1e-6);
    const Eigen::AlignedBox3d box = boundingBox(row);
    EXPECT_NEAR(box.sizes().x(), 20 + kGapOfParts, 1e-6);
    EXPECT_NEAR(box.sizes().y(), 10, 1e-6);
    EXPECT_NEAR(box.sizes().z(), 10, 1e-6);
    EXPECT_NEAR(box.center().norm(), 0, 1e-6);
}

TEST(FrameOfRun, TakesPlacesBackToWhereTheirPartIs)
{
    const TriangleMesh mesh = cubesApart(3000);
    const FrameOfRun frame(Scene(), mesh, boundingBox(mesh), 0.1);
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.2, 0.3, 0.4), {3000.9, 6000.1, 0.5}})
    {
        EXPECT_NEAR((frame.toMesh(frame.toRun(p)) - p).norm(), 0, 1e-9);
        EXPECT_LT(frame.toRun(p).norm(), 30);
    }
}

FrameOfRun frameOf(const Scene& scene, double distance, double radius)
{
    const TriangleMesh mesh = cubesApart(distance);
    return {scene, mesh, boundingBox(mesh), radius};
}

TEST(FrameOfRun, LeavesPartsWhereTheyAreWhenLittleIsToBeSaved)
{
    EXPECT_TRUE(frameOf(Scene(), 3, 0.1).moved.empty());
    EXPECT_TRUE(frameOf(Scene(), 3000, 500).moved.empty());
    Scene moving;
    moving.move.tilt = 10;
    EXPECT_TRUE(frameOf(moving, 3000, 0.1).moved.empty()) << "forces depend on the place";
}

} // namespace
} // namespace frostfill
