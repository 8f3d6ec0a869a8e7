// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// A bar through the whole of its box, of twelve triangles: 4,000 long, and 6 thick.
TriangleMesh slantedBar()
{
    TriangleMesh mesh = shapes::box({-3, -2000, -3}, {3, 2000, 3});
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = turn * vertex;
    }
    return mesh;
}

// The box has room for 1.8e10 cubes of the radius; one of them in 120,000 is inside.
TEST(LargeBox, IsFilledWhereItsObjectIs)
{
    const TriangleMesh mesh = slantedBar();
    const Eigen::Vector3d size = boundingBox(mesh).sizes();
    ASSERT_GT(size.prod(), 1e10);
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = presetScene(Preset::fast, "bar");
        scene.spheres.radius = 1;
        scene.spheres.count = 60;
        scene.motion.mode = motion;
        scene.discard.rule = DiscardRule::none;
        Simulation without(scene, mesh);
        test::runToEnd(without);
        scene.discard.rule = DiscardRule::exact;
        Simulation simulation(scene, mesh);
        test::runToEnd(simulation);
        EXPECT_EQ(simulation.sphereCount(), 60u);
        EXPECT_EQ(simulation.stateHash(), without.stateHash());
        const QualityReport error = simulation.quality();
        EXPECT_EQ(error.centresOutside, 0u);
        EXPECT_LT(error.maxOverlap, 1e-7);
        EXPECT_LT(error.maxWallOverlap, 1e-7);
    }
}

} // namespace
} // namespace frostfill
