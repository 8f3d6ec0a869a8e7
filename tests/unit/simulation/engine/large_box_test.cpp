// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"
#include "unit/simulation/engine/small_torus.hpp"
#include "unit/simulation/reach/reach_scene.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TriangleMesh slanted(TriangleMesh mesh)
{
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = turn * vertex;
    }
    return mesh;
}

/// The run of a scene to its end, by its rule of discards.
Simulation endOf(Scene scene, const TriangleMesh& mesh, DiscardRule rule)
{
    scene.discard.rule = rule;
    Simulation simulation(scene, mesh);
    test::runToEnd(simulation);
    return simulation;
}

/// A bar through the whole of its box, of twelve triangles: 4,000 long, and 6 thick.
TriangleMesh slantedBar()
{
    return slanted(shapes::box({-3, -2000, -3}, {3, 2000, 3}));
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
        const Simulation without = endOf(scene, mesh, DiscardRule::none);
        const Simulation simulation = endOf(scene, mesh, DiscardRule::exact);
        EXPECT_EQ(simulation.sphereCount(), 60u);
        EXPECT_EQ(simulation.stateHash(), without.stateHash());
        const QualityReport error = simulation.quality();
        EXPECT_EQ(error.centresOutside, 0u);
        EXPECT_LT(error.maxOverlap, 1e-7);
        EXPECT_LT(error.maxWallOverlap, 1e-7);
    }
}

/// Two boxes of 6 x 6 x 6, 500 apart, and a passage between them that is too narrow.
TriangleMesh slantedDumbbell()
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {6, 6, 6});
    reach::addBlock(cells, {2, 6, 2}, {3, 506, 3});
    reach::addBlock(cells, {0, 506, 0}, {6, 512, 6});
    return slanted(reach::cubes(cells));
}

// 1.4e8 cubes of the map, which would take 90 MB.
TEST(LargeBox, DiscardsWhatIsOutOfReachInIt)
{
    Scene scene = presetScene(Preset::fast, "dumbbell");
    scene.spheres.radius = 1;
    scene.spheres.count.reset(); // until full
    scene.motion.mode = Motion::skip;
    const TriangleMesh mesh = slantedDumbbell();
    const Simulation without = endOf(scene, mesh, DiscardRule::none);
    const Simulation simulation = endOf(scene, mesh, DiscardRule::exact);
    ASSERT_GT(simulation.sphereCount(), 20u);
    EXPECT_EQ(simulation.stateHash(), without.stateHash());
    EXPECT_GT(simulation.sets().back().discarded, simulation.sphereCount() / 2);
    EXPECT_GT(simulation.sets().back().discardedPolygons, mesh.triangles.size() / 2);
    const ReachInspection reach = simulation.inspectReach(std::size_t{8} << 20);
    ASSERT_TRUE(reach.known);
    EXPECT_NEAR(reach.unreachable, 500, 50);
}

// Two boxes of 6 x 6 x 6, side by side or one above the other: the box around both has room for
// 2.4e10 cubes of the radius.
TEST(LargeBox, IsFilledInAllPartsThatLieFarApart)
{
    for (const Eigen::Vector3d& apart : {Eigen::Vector3d(40000, 0, 20000), {9000, 60000, 7000}})
    {
        TriangleMesh mesh = shapes::box({0, 0, 0}, {6, 6, 6});
        test::append(mesh, shapes::box(apart, apart.array() + 6));
        for (const Motion motion : {Motion::skip, Motion::descend})
        {
            Scene scene = presetScene(Preset::fast, "boxes");
            scene.spheres.radius = 1;
            scene.spheres.count.reset(); // until full
            scene.motion.mode = motion;
            const Simulation simulation = endOf(scene, mesh, DiscardRule::exact);
            EXPECT_TRUE(simulation.full());
            std::size_t inFirst = 0;
            for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
            {
                inFirst += simulation.sphere(id).centre.x() < 6 ? 1 : 0;
            }
            EXPECT_GE(inFirst, 18u);
            EXPECT_GE(simulation.sphereCount() - inFirst, 18u);
            const QualityReport error = simulation.quality();
            EXPECT_EQ(error.centresOutside, 0u);
            EXPECT_EQ(error.unsupported, 0u);
            EXPECT_LT(error.maxOverlap, 1e-7);
        }
    }
}

} // namespace
} // namespace frostfill
